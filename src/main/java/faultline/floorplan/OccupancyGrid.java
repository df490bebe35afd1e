package faultline.floorplan;

import java.util.Arrays;

/** A map of square cells. Column 0 is at the left and row 0 at the bottom. Immutable. */
public final class OccupancyGrid {

    private static final CellState[] STATES = CellState.values();

    private final int width;
    private final int height;
    private final byte[] cells;

    /**
     * Creates a grid.
     *
     * @param width number of columns, at least 1
     * @param height number of rows, at least 1
     * @param cells the states, row by row from the bottom; copied
     * @throws IllegalArgumentException if the sizes do not match
     */
    public OccupancyGrid(int width, int height, CellState[] cells) {
        this(width, height, toBytes(cells));
    }

    /** Takes over an array of ordinals. */
    OccupancyGrid(int width, int height, byte[] ordinals) {
        if (width < 1 || height < 1 || (long) width * height != ordinals.length) {
            throw new IllegalArgumentException(
                    width + " x " + height + " cells do not match " + ordinals.length + " states");
        }
        this.width = width;
        this.height = height;
        this.cells = ordinals;
    }

    private static byte[] toBytes(CellState[] states) {
        byte[] ordinals = new byte[states.length];
        for (int i = 0; i < ordinals.length; i++) {
            ordinals[i] = (byte) states[i].ordinal();
        }
        return ordinals;
    }

    /** {@return the number of columns} */
    public int width() {
        return width;
    }

    /** {@return the number of rows} */
    public int height() {
        return height;
    }

    /**
     * {@return the state of a cell}
     *
     * @param column the column, in [0, width)
     * @param row the row, in [0, height), from the bottom
     */
    public CellState state(int column, int row) {
        return STATES[cells[row * width + column]];
    }

    /**
     * {@return the cells that obstruct the robot}
     *
     * @param unknownIsSolid whether unknown cells count as solid
     */
    public SolidCells solidCells(boolean unknownIsSolid) {
        boolean[] solid = new boolean[cells.length];
        for (int i = 0; i < solid.length; i++) {
            solid[i] = cells[i] == CellState.OCCUPIED.ordinal()
                    || unknownIsSolid && cells[i] == CellState.UNKNOWN.ordinal();
        }
        return new SolidCells(width, height, solid);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof OccupancyGrid grid && grid.width == width && Arrays.equals(grid.cells, cells);
    }

    @Override
    public int hashCode() {
        return 31 * width + Arrays.hashCode(cells);
    }
}
