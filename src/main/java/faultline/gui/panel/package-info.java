/**
 * The control panel: the robot's platform, its sensors with their readings, and its faults. Event dispatch thread only,
 * asserted. Panels show snapshots and send commands; the effect of a command appears with a later snapshot, so that a
 * refused one reverts automatically.
 */
package faultline.gui.panel;
