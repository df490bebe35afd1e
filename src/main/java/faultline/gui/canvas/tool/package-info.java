/**
 * The tools and gestures of the canvas: what a mouse press takes hold of, what a drag changes, and where things may be
 * placed. Event dispatch thread only. Tools send commands to a sink and never see a session.
 */
package faultline.gui.canvas.tool;
