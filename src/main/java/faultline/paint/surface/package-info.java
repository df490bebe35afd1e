/**
 * Drawing surfaces: one small interface over {@link java.awt.Graphics2D} and SVG, with the camera, line styles, colours
 * and labels that all painters share. Nothing here knows what is drawn. Objects belong to the thread that owns the
 * graphics.
 */
package faultline.paint.surface;
