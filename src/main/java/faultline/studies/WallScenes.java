package faultline.studies;

import faultline.engine.SimulationSetup;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.ObstacleShape;
import java.util.List;

/** The walls of the trials of eq. (4), and the starts before them; variants start at another distance and angle. */
final class WallScenes {

    private static final double WALL_Y = AlignmentTrial.WALL_Y;
    private static final double WALL_LENGTH = 4;
    private static final double START_OFFSET = 1.4;

    private WallScenes() {}

    /** Returns the file's wall, whose ends are out of range of all cones. */
    static SimulationSetup endless(SimulationSetup base, double distance, int variant) {
        double away = distance + 0.25 + 0.0137 * variant;
        double slant = Degrees.toRadians(2.0 * variant + 1);
        return base.withStart(
                new Pose(WALL_Y + away * StrictMath.tan(slant) * 0.5, WALL_Y - away, StrictMath.PI / 2 + slant));
    }

    /** Returns a wall that ends ahead of the robot's foot point. */
    static SimulationSetup ending(SimulationSetup base, double ahead, double distance, int variant) {
        List<Vector2> points = List.of(new Vector2(WALL_Y - WALL_LENGTH, WALL_Y), new Vector2(WALL_Y + ahead, WALL_Y));
        return SetupVariations.with(
                endless(base, distance, variant),
                SetupVariations.findObstacle(base, "wall").withShape(new ObstacleShape.WallShape(points)));
    }

    /**
     * Returns an inner corner: the robot reaches one wall, follows it, and is then aligned with the other, which lies
     * on y = {@link AlignmentTrial#WALL_Y}.
     */
    static SimulationSetup corner(SimulationSetup base, double angle, double distance, int variant) {
        Vector2 corner = new Vector2(WALL_Y, WALL_Y);
        Vector2 alongFirst = Vector2.direction(-angle);
        Vector2 inward = alongFirst.perpendicular();
        List<Vector2> points =
                List.of(corner.plus(alongFirst.times(WALL_LENGTH)), corner, corner.plus(new Vector2(WALL_LENGTH, 0)));
        Vector2 start =
                corner.plus(alongFirst.times(START_OFFSET + 0.0213 * variant)).plus(inward.times(distance + 0.3));
        SimulationSetup bent = SetupVariations.with(
                base, SetupVariations.findObstacle(base, "corner").withShape(new ObstacleShape.WallShape(points)));
        return bent.withStart(new Pose(start.x(), start.y(), inward.angle() + StrictMath.PI + Degrees.toRadians(2)));
    }
}
