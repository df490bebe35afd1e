package faultline.floorplan;

/** What a map says of one cell. */
public enum CellState {
    /** The cell was seen free. */
    FREE,
    /** The cell was seen occupied. */
    OCCUPIED,
    /** The map does not tell. */
    UNKNOWN
}
