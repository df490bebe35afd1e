package faultline.engine.trace;

/**
 * A column of a trace.
 *
 * @param name the name in the header row
 * @param unit the unit of its numbers, empty if they have none
 * @param meaning in one phrase
 */
public record TraceColumn(String name, String unit, String meaning) {}
