/**
 * Our own small plotter. A picture is told to a {@link faultline.paint.surface.Drawing} in strokes, fills and texts,
 * and a drawing is either an SVG file or a {@link java.awt.Graphics2D}; so a figure on paper and a chart in the window
 * are one and the same. Nothing here measures text with the machine's fonts, reads a clock or depends on a hash order:
 * the same picture gives the same bytes everywhere.
 */
package faultline.paint.plot;
