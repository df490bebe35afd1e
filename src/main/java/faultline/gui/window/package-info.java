/**
 * The main window: its menus, its contents, and the timer that polls the run for them. Event dispatch thread only,
 * asserted.
 */
package faultline.gui.window;
