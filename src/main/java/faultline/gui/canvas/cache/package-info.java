/**
 * Cached layers of the canvas: images of what rarely changes, rebuilt over several frames within a time budget so that
 * no picture takes long. Event dispatch thread only.
 */
package faultline.gui.canvas.cache;
