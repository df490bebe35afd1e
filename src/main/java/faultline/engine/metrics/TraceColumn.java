package faultline.engine.metrics;

import faultline.engine.Simulation;
import java.util.function.BiConsumer;

/**
 * A column of a trace.
 *
 * @param name in the header row
 * @param unit of its numbers, empty if they have none
 * @param meaning in one phrase
 * @param cell appends its cell of a moment to a row
 */
public record TraceColumn(String name, String unit, String meaning, BiConsumer<Simulation, TraceRow> cell) {}
