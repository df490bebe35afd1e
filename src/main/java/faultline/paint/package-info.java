/**
 * From a frame to pixels: the one painter that the window's canvas and the picture files share. It reads immutable
 * frames and writes to a {@link java.awt.Graphics2D}; whoever owns that graphics owns the thread. Nothing here knows of
 * components, events or a display.
 */
package faultline.paint;
