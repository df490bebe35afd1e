/**
 * Charts and the state diagram: axes, ticks, series, legends and their layout, drawn on a surface for figures and for
 * the instruments of the window. No text is measured with the fonts of the machine, so the same chart has the same
 * bytes everywhere.
 */
package faultline.paint.chart;
