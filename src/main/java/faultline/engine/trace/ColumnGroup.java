package faultline.engine.trace;

import faultline.engine.Simulation;
import java.util.List;

/** Columns of a trace that are written together, because a call for each cell would take longer than its text. */
interface ColumnGroup {

    /** Returns the columns, in the order of the cells. */
    List<TraceColumn> columns();

    /** Appends a cell of this moment for each column. */
    void append(Simulation simulation, TraceRows rows);
}
