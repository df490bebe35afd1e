package faultline.campaign;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A random room: a ring of walls with inner corners of at most 150 degrees and outer corners, furniture, poles and
 * visitors. No passage is narrower than {@link #PASSAGE}, to 1 mm; obstacles at a wall touch it. The same seed gives
 * the same room, and the same room with other visitors.
 *
 * @param world the walls and all obstacles
 * @param start the initial pose of the robot, at least {@link #START_CLEARANCE} from everything, to 1 mm
 */
public record RandomRoom(WorldSpec world, Pose start) {

    /** The width of the narrowest passage, metres. */
    public static final double PASSAGE = 0.9;

    /** The minimum distance from the start to everything, metres. */
    public static final double START_CLEARANCE = 0.45;

    /** The width and the height of the world, metres. */
    static final double SIZE = 12;

    private static final int MAX_TRIES = 400;

    /**
     * {@return a room with inner corners of 60 degrees and more, without visitors}
     *
     * @param seed the seed of all random numbers
     */
    public static RandomRoom ofSeed(long seed) {
        return ofSeed(seed, RoomRules.DEFAULT);
    }

    /**
     * {@return a room}
     *
     * @param seed the seed of all random numbers
     * @param rules the rules for its corners and visitors
     */
    public static RandomRoom ofSeed(long seed, RoomRules rules) {
        SplittableRandom random = new SplittableRandom(seed);
        while (true) {
            List<Vector2> ring = RandomRing.next(random, StrictMath.toRadians(rules.minCorner()));
            RoomPlan plan = new RoomPlan(ring);
            furnish(plan, random);
            for (int i = 0; i < MAX_TRIES; i++) {
                Vector2 at = new Vector2(random.nextDouble(SIZE), random.nextDouble(SIZE));
                if (plan.surrounds(at) && plan.distance(at) >= START_CLEARANCE) {
                    Pose start = new Pose(at.x(), at.y(), random.nextDouble(2 * StrictMath.PI));
                    List<Obstacle> obstacles = plan.obstacles();
                    obstacles.addAll(new RandomVisitors(plan, at, seed).make(rules.visitors()));
                    return new RandomRoom(
                            new WorldSpec(SIZE, SIZE, false, WorldSpec.DEFAULT_MAX_MOVING, obstacles), start);
                }
            }
        }
    }

    private static void furnish(RoomPlan plan, SplittableRandom random) {
        int furniture = random.nextInt(4);
        int poles = random.nextInt(4);
        for (int i = 0; i < MAX_TRIES && furniture > 0; i++) {
            furniture -= plan.add(furniture(plan, "furniture-" + furniture, random)) ? 1 : 0;
        }
        for (int i = 0; i < MAX_TRIES && poles > 0; i++) {
            poles -= plan.add(pole(plan, "pole-" + poles, random)) ? 1 : 0;
        }
    }

    /** Returns furniture, free-standing or with its back flush with a wall. */
    private static RoomPlan.Item furniture(RoomPlan plan, String id, SplittableRandom random) {
        double width = random.nextDouble(0.3, 1.2);
        double depth = random.nextDouble(0.3, 0.8);
        boolean free = random.nextBoolean();
        Vector2 at = new Vector2(random.nextDouble(SIZE), random.nextDouble(SIZE));
        double heading = random.nextDouble(2 * StrictMath.PI);
        int wall = -1;
        if (!free) {
            wall = random.nextInt(plan.walls());
            Vector2 along = plan.along(wall);
            at = plan.pointOn(wall, random.nextDouble())
                    .plus(along.perpendicular().times(depth / 2));
            heading = along.angle();
        }
        return new RoomPlan.Item(
                new Obstacle(
                        id,
                        new ObstacleShape.RectangleShape(width, depth),
                        new Pose(at.x(), at.y(), heading),
                        WaypointPath.NONE),
                outline(at, heading, width, depth),
                0,
                wall);
    }

    private static List<Vector2> outline(Vector2 at, double heading, double width, double depth) {
        Vector2 x = Vector2.direction(heading).times(width / 2);
        Vector2 y = Vector2.direction(heading).perpendicular().times(depth / 2);
        List<Vector2> corners = new ArrayList<>();
        corners.add(at.plus(x).plus(y));
        corners.add(at.minus(x).plus(y));
        corners.add(at.minus(x).minus(y));
        corners.add(at.plus(x).minus(y));
        return corners;
    }

    /** Returns a pole, free-standing or touching a wall. */
    private static RoomPlan.Item pole(RoomPlan plan, String id, SplittableRandom random) {
        double radius = random.nextDouble(0.01, 0.06);
        boolean free = random.nextInt(3) > 0;
        Vector2 at = new Vector2(random.nextDouble(SIZE), random.nextDouble(SIZE));
        int wall = -1;
        if (!free) {
            wall = random.nextInt(plan.walls());
            at = plan.pointOn(wall, random.nextDouble())
                    .plus(plan.along(wall).perpendicular().times(radius));
        }
        return new RoomPlan.Item(
                new Obstacle(id, new ObstacleShape.CircleShape(radius), new Pose(at.x(), at.y(), 0), WaypointPath.NONE),
                List.of(at),
                radius,
                wall);
    }
}
