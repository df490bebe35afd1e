/**
 * The tools and gestures of the canvas: what a mouse press starts, what a drag changes, and where there is room for
 * obstacles. Event dispatch thread only. Tools send commands and never see a session.
 */
package faultline.gui.canvas.tool;
