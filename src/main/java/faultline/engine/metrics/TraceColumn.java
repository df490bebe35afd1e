package faultline.engine.metrics;

/**
 * A column of a trace.
 *
 * @param name in the header row
 * @param unit of its numbers, empty if they have none
 * @param meaning in one phrase
 */
public record TraceColumn(String name, String unit, String meaning) {}
