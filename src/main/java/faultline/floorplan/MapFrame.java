package faultline.floorplan;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import java.util.List;

/**
 * Where a map lies in its world, which contains all of it. A world has the size of its map, or of the bounding box of a
 * map that is rotated.
 *
 * @param lowerLeft the pose of the map's lower left corner in the world
 * @param width the width of the world, metres
 * @param height the height of the world, metres
 */
record MapFrame(Pose lowerLeft, double width, double height) {

    /** The step to which the place and the size of a rotated map are rounded, metres. */
    private static final double STEP = 1e-6;

    private static final double STEPS_PER_METRE = 1e6;

    /** Returns the frame of a map with a number of cells. */
    static MapFrame of(MapDescription description, int columns, int rows) {
        double width = description.metres(columns);
        double height = description.metres(rows);
        if (description.yaw() == 0) {
            return new MapFrame(new Pose(0, 0, 0), width, height);
        }
        RigidMotion turn = RigidMotion.rotationAbout(Vector2.ZERO, description.yaw());
        List<Vector2> corners = List.of(
                turn.toParent(new Vector2(0, 0)),
                turn.toParent(new Vector2(width, 0)),
                turn.toParent(new Vector2(width, height)),
                turn.toParent(new Vector2(0, height)));
        double left = 0;
        double below = 0;
        for (Vector2 corner : corners) {
            left = Math.max(left, -corner.x());
            below = Math.max(below, -corner.y());
        }
        Pose lowerLeft = new Pose(roundUp(left), roundUp(below), description.yaw());
        double maxX = 0;
        double maxY = 0;
        for (Vector2 corner : corners) {
            maxX = Math.max(maxX, corner.x() + lowerLeft.x());
            maxY = Math.max(maxY, corner.y() + lowerLeft.y());
        }
        return new MapFrame(lowerLeft, round(maxX + STEP), round(maxY + STEP));
    }

    /** Returns a length rounded to the step. */
    static double round(double metres) {
        return Math.rint(metres * STEPS_PER_METRE) / STEPS_PER_METRE;
    }

    /** Returns a length rounded up to the step, so that no part of the map is at negative coordinates. */
    private static double roundUp(double metres) {
        return Math.ceil(metres * STEPS_PER_METRE) / STEPS_PER_METRE;
    }
}
