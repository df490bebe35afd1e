package faultline.engine.walls;

import faultline.geometry.ConvexShape;
import faultline.geometry.Vector2;
import faultline.world.SpatialIndex;
import java.util.ArrayList;
import java.util.List;

/** The places along all walls by comparing each with every wall: the reference implementation of their sampling. */
final class BruteForceSamples {

    private BruteForceSamples() {}

    /** Returns the samples, given the distance that neighbours around a round wall must not exceed. */
    static List<WallReference.WallSample> of(
            WallReference walls, double distance, double spacing, double reach, double joinDistance) {
        List<WallReference.WallSample> places = new ArrayList<>();
        List<Vector2> circle = PlaceRow.circle(distance, spacing);
        for (int i = 0; i < walls.size(); i++) {
            List<PlaceRow> rows = PlaceRow.of(walls.walls().shape(i), distance, spacing, reach, circle).stream()
                    .map(row -> row.joined(joinDistance))
                    .toList();
            boolean bothSides = rows.get(0) instanceof PlaceRow.Side;
            for (int place = 0; bothSides && place < rows.get(0).size(); place++) {
                addIfFree(walls.walls(), rows.get(0), place, distance, places);
                addIfFree(walls.walls(), rows.get(1), place, distance, places);
            }
            for (PlaceRow row : rows.subList(bothSides ? 2 : 0, rows.size())) {
                for (int place = 0; place < row.size(); place++) {
                    addIfFree(walls.walls(), row, place, distance, places);
                }
            }
        }
        return places;
    }

    private static void addIfFree(
            SpatialIndex walls, PlaceRow row, int index, double distance, List<WallReference.WallSample> places) {
        Vector2 place = row.place(index);
        for (int i = 0; i < walls.size(); i++) {
            ConvexShape wall = walls.shape(i);
            if (WallReference.nearness(wall, place, distance) > 0) {
                return;
            }
        }
        places.add(new WallReference.WallSample(place, row.offset(index), row.wallLength(index)));
    }
}
