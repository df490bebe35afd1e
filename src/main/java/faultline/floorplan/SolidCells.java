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
        Group group = new Group(minCells);
        for (int start = 0; start < solid.length; start++) {
            if (solid[start] && !group.visited[start]) {
                group.collect(start);
                for (int i = 0; group.size < minCells && i < group.size; i++) {
                    kept[group.cells[i]] = false;
                }
            }
        }
        return new SolidCells(width, height, kept);
    }

    /**
     * Returns the number of corners of all outlines: one where an odd number of the four cells around a point is solid,
     * two where cells touch at a corner only.
     */
    long cornerCount() {
        long corners = 0;
        for (int row = 0; row <= height; row++) {
            for (int column = 0; column <= width; column++) {
                boolean a = isSolid(column - 1, row - 1);
                boolean b = isSolid(column, row - 1);
                boolean c = isSolid(column - 1, row);
                boolean d = isSolid(column, row);
                if (a ^ b ^ c ^ d) {
                    corners++;
                } else if (a == d && a != b) {
                    corners += 2;
                }
            }
        }
        return corners;
    }

    /** The cells that are connected to a cell, collected breadth first. */
    private final class Group {
        private final boolean[] visited = new boolean[solid.length];
        private final int minCells;
        /** All cells of a small group. For a large group, only those whose neighbours have not been visited. */
        private int[] cells = new int[64];

        private int end;
        private int size;

        Group(int minCells) {
            this.minCells = minCells;
        }

        void collect(int start) {
            end = 0;
            size = 0;
            add(start);
            for (int next = 0; next < end; next++) {
                if (end == cells.length && size >= minCells && next > end / 2) {
                    System.arraycopy(cells, next, cells, 0, end - next);
                    end -= next;
                    next = 0;
                }
                int column = cells[next] % width;
                int row = cells[next] / width;
                visit(column - 1, row);
                visit(column + 1, row);
                visit(column, row - 1);
                visit(column, row + 1);
            }
        }

        private void visit(int column, int row) {
            if (isSolid(column, row) && !visited[row * width + column]) {
                add(row * width + column);
            }
        }

        private void add(int cell) {
            if (end == cells.length) {
                cells = Arrays.copyOf(cells, 2 * end);
            }
            visited[cell] = true;
            cells[end++] = cell;
            size++;
        }
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
