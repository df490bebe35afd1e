package faultline.floorplan;

import java.util.Arrays;

/**
 * The solid cells of a map. Column 0 is at the left and row 0 at the bottom; cells beyond the map are not solid.
 * Immutable.
 */
public final class SolidCells {

    private final int width;
    private final int height;
    private final boolean[] solid;

    /** Takes over an array of cells, row by row from the bottom. */
    SolidCells(int width, int height, boolean[] solid) {
        this.width = width;
        this.height = height;
        this.solid = solid;
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
     * {@return whether a cell is solid; false beyond the map}
     *
     * @param column any number
     * @param row any number, from the bottom
     */
    public boolean isSolid(int column, int row) {
        return column >= 0 && row >= 0 && column < width && row < height && solid[row * width + column];
    }

    /** {@return the number of solid cells} */
    public int count() {
        int count = 0;
        for (boolean cell : solid) {
            count += cell ? 1 : 0;
        }
        return count;
    }

    /**
     * {@return these cells without small specks} Cells that share a side belong together.
     *
     * @param minCells the minimum size of a group; smaller groups are dropped
     */
    public SolidCells withoutSpecks(int minCells) {
        if (minCells <= 1) {
            return this;
        }
        boolean[] kept = solid.clone();
        boolean[] visited = new boolean[solid.length];
        int[] group = new int[solid.length];
        for (int start = 0; start < solid.length; start++) {
            if (solid[start] && !visited[start]) {
                int size = collectGroup(start, visited, group);
                for (int i = 0; size < minCells && i < size; i++) {
                    kept[group[i]] = false;
                }
            }
        }
        return new SolidCells(width, height, kept);
    }

    /** Collects the cells that are connected to a cell, breadth first, and returns their number. */
    private int collectGroup(int start, boolean[] visited, int[] group) {
        int size = 0;
        group[size++] = start;
        visited[start] = true;
        for (int next = 0; next < size; next++) {
            int column = group[next] % width;
            int row = group[next] / width;
            size = visit(column - 1, row, visited, group, size);
            size = visit(column + 1, row, visited, group, size);
            size = visit(column, row - 1, visited, group, size);
            size = visit(column, row + 1, visited, group, size);
        }
        return size;
    }

    private int visit(int column, int row, boolean[] visited, int[] group, int size) {
        int index = row * width + column;
        if (!isSolid(column, row) || visited[index]) {
            return size;
        }
        visited[index] = true;
        group[size] = index;
        return size + 1;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof SolidCells cells && cells.width == width && Arrays.equals(cells.solid, solid);
    }

    @Override
    public int hashCode() {
        return 31 * width + Arrays.hashCode(solid);
    }
}
