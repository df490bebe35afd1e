/**
 * The canvas of the window: shows frames, lets the user zoom, pan, move and rotate, and sends edits as commands. Event
 * dispatch thread only. It never sees a session.
 */
package faultline.gui.canvas;
