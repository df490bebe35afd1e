package faultline.paint.chart;

import faultline.paint.surface.TextStyle;

/**
 * The style of the ticks of both axes.
 *
 * @param text the text of their labels; its anchor is ignored
 * @param markLength the length of the mark at each tick, pixels; 0 for none
 * @param left from the plot to the end of a label of the vertical axis, pixels
 * @param below from the plot to the baseline of the labels of the horizontal axis, pixels
 * @param unit appended to the labels of the horizontal axis, may be empty
 */
public record TickStyle(TextStyle text, double markLength, double left, double below, String unit) {}
