/**
 * Charts: axes, ticks, series, legends and their layout, drawn on a surface. Text is never measured with the machine's
 * fonts where the result goes to a file, so the same chart gives the same bytes everywhere.
 */
package faultline.paint.chart;
