/**
 * The window: menus, tool bar, canvas, control panel, status bar, dialogs, and what is remembered of it. Event dispatch
 * thread only, asserted.
 */
package faultline.gui.window;
