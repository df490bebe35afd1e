package faultline.engine.walls;

import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import java.util.function.Consumer;

/** Finds the places of rows that no wall is nearer to than the wall of the row is, as blocks. */
final class PlaceFinder {

    private final WallTree walls;
    private final double distance;
    private final double joinDistance;
    private final int maxEmpty;
    private int empty;

    /**
     * Creates a search.
     *
     * @param walls the walls
     * @param distance the distance of the places from the walls, metres
     * @param joinDistance the greatest distance between places that are joined, metres; infinite if no blocks are alone
     * @param maxEmpty the maximum number of blocks without free places
     */
    PlaceFinder(WallTree walls, double distance, double joinDistance, int maxEmpty) {
        this.walls = walls;
        this.distance = distance;
        this.joinDistance = joinDistance;
        this.maxEmpty = maxEmpty;
    }

    /** Returns the number of blocks without free places so far. */
    int empty() {
        return empty;
    }

    /** Returns the part of the arc around an end of a wall that neither it nor a neighbour at that end occupies. */
    PlaceRow.Arc outside(PlaceRow.Arc arc, Segment wall) {
        int neighbour = walls.find(
                arc.corner(),
                0,
                i -> walls.wall(i) instanceof Segment other && !other.equals(wall) && arc.isAtEndOf(other));
        return arc.outside(wall, neighbour == WallTree.NONE ? wall : (Segment) walls.wall(neighbour));
    }

    /**
     * Finds the blocks of the places of a row that have free ones.
     *
     * @param wall the wall of the row
     * @param row the row
     * @param action takes each block
     * @throws WallReference.PathTooLongException if there are too many blocks without free places, which take time
     */
    void forEachFree(ConvexShape wall, PlaceRow row, Consumer<PlaceBlock> action) {
        int length = Double.isInfinite(joinDistance) ? PlaceBlock.SHORT : PlaceBlock.LONG;
        for (int from = 0; from < row.size(); from += length) {
            int end = Math.min(from + length, row.size());
            PlaceBlock all = block(wall, row, from, end);
            if (all.isAlone() || end - from <= PlaceBlock.SHORT) {
                acceptIfFree(all, action);
                continue;
            }
            for (int next = from; next < end; next += PlaceBlock.SHORT) {
                acceptIfFree(block(wall, row, next, Math.min(next + PlaceBlock.SHORT, end)), action);
            }
        }
    }

    private PlaceBlock block(ConvexShape wall, PlaceRow row, int from, int end) {
        PlaceBlock block = new PlaceBlock(row, from, end, joinDistance);
        int shared = 2 * distance > joinDistance ? row.shared(joinDistance) : row.size();
        block.occupy(wall, walls, distance, joinDistance, shared);
        return block;
    }

    private void acceptIfFree(PlaceBlock block, Consumer<PlaceBlock> action) {
        if (block.hasFree()) {
            action.accept(block);
            return;
        }
        if (empty == maxEmpty) {
            throw new WallReference.PathTooLongException(distance, maxEmpty);
        }
        empty++;
    }
}
