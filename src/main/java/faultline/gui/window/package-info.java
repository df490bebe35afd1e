/** The main window: menus, tool bar, canvas, control panel and status bar. Event dispatch thread only, asserted. */
package faultline.gui.window;
