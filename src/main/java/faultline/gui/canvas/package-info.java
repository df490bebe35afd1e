/**
 * The canvas of the window: shows frames, lets the hand zoom, pan, move and rotate, and sends what the hand does as
 * commands. Event dispatch thread only, asserted. It never sees a session: frames come in by
 * {@link faultline.gui.canvas.SimulationCanvas#setFrame(faultline.engine.Frame)}, commands go out to a consumer.
 */
package faultline.gui.canvas;
