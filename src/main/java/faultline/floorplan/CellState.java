package faultline.floorplan;

/** The occupancy of one cell in a map. */
public enum CellState {
    /** The cell was seen free. */
    FREE,
    /** The cell was seen occupied. */
    OCCUPIED,
    /** The map does not say whether the cell is occupied. */
    UNKNOWN
}
