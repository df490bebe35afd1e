/**
 * The time line: the slider of the run, and below it the scenario's faults, switches and moves as bars and marks that
 * can be drawn, moved and edited, for the whole run or a part of it. {@link faultline.gui.timeline.TimelineModel} pairs
 * the commands of a scenario, {@link faultline.gui.timeline.TimelineEditor} changes them. Event dispatch thread only;
 * knows no instruments.
 */
package faultline.gui.timeline;
