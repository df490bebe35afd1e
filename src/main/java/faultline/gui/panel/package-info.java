/**
 * The control panel: the robot's platform, its sensors with their readings, and its faults. Event dispatch thread only,
 * asserted. Panels are shown snapshots and give commands; what a command changed shows when a snapshot brings it back,
 * so a refused one undoes itself.
 */
package faultline.gui.panel;
