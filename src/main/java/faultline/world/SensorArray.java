package faultline.world;

import faultline.geometry.BoxDistance;
import faultline.geometry.ConvexShape;
import faultline.geometry.OrientedBox;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.SectorIntersections;
import faultline.geometry.Segment;
import faultline.geometry.SpecularDistance;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultSequence;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The robot's sensors in action: true and reported readings, tick by tick; mutable, confined to the simulation thread.
 *
 * <p>The static shapes that a sensor may see are collected for all poses near the present one, and again when the robot
 * has left that region or obstacles have been edited.
 */
final class SensorArray {

    /** The region's extent as a share of the longest range. */
    private static final double TRAVEL_PER_RANGE = 0.125;

    private static final double MIN_TRAVEL = 0.02;
    private static final double MAX_TRAVEL = 0.15;
    private static final double MAX_TURN = 0.25;

    /** Rounding must not hide an outline that is just within a distance, metres. */
    private static final double MARGIN = 1e-6;

    private final double dt;
    private SensorSignal[] signals;
    /** The cones of the sensors without faults. */
    private final SensorCone[] soundCones;
    /** The cones with the faults of the optics; the same objects where there are none. */
    private final SensorCone[] actualCones;

    private final CandidateBuffer candidates = new CandidateBuffer();
    private final CandidateBuffer farCandidates = new CandidateBuffer();
    private final List<MovingObstacle> movingNear = new ArrayList<>();
    /** The shapes that may come between the robot's centre and an apex beside the body in the region. */
    private final CandidateBuffer outlinesNear = new CandidateBuffer();
    /** The insides of floor plans in the region, of those that were asked for. */
    private final Map<ShapeOwner, RingList.Neighbourhood> plansNear = new HashMap<>();
    /** The indexes of the sensors that may see something in the region; the first {@link #awakeCount} are valid. */
    private final int[] awake;

    private int awakeCount;
    private final double[] truth;
    private double[] reported;
    /** The readings that snapshots show: the reported ones, or those of {@link #resample} until the next tick. */
    private double[] shown;

    private RobotSpec robot;
    private double sensingRadius;
    /** The distance of the farthest apex beside the body from the robot's centre, metres; 0 if there is none. */
    private double outsideRadius;

    private double maxTravel;

    // The region of the collected shapes.
    private long version = -1;
    private double regionX;
    private double regionY;
    private double regionHeading;
    private double regionCos;
    private double regionSin;
    /** The distance of the robot's centre from the pose at which the shapes were collected, metres. */
    private double driven;
    /** The angle between the robot's heading and that of this pose, radians. */
    private double turned;

    SensorArray(RobotSpec robot, long seed, double dt) {
        this.dt = dt;
        signals = robot.sensors().stream()
                .map(spec -> new SensorSignal(spec, seed))
                .toArray(SensorSignal[]::new);
        soundCones = new SensorCone[signals.length];
        actualCones = new SensorCone[signals.length];
        awake = new int[signals.length];
        truth = new double[signals.length];
        reported = new double[signals.length];
        Arrays.fill(reported, Reading.NOTHING);
        shown = reported;
        configure(robot);
    }

    /** Applies changed settings of the sensors or the platform. */
    void configure(RobotSpec newRobot) {
        robot = newRobot;
        double longest =
                robot.sensors().stream().mapToDouble(SensorSpec::range).max().orElse(0);
        maxTravel = Math.max(MIN_TRAVEL, Math.min(MAX_TRAVEL, TRAVEL_PER_RANGE * longest));
        sensingRadius = 0;
        outsideRadius = 0;
        for (int i = 0; i < signals.length; i++) {
            SensorSpec spec = robot.sensors().get(i);
            signals[i].configure(spec);
            soundCones[i] = new SensorCone(spec, Obstacle.MATT, robot, maxTravel, MAX_TURN);
            actualCones[i] = createActualCone(i);
            double mountDistance = spec.mountPosition().length();
            sensingRadius = Math.max(sensingRadius, mountDistance + spec.range());
            outsideRadius = soundCones[i].isOutsideBody() ? Math.max(outsideRadius, mountDistance) : outsideRadius;
        }
        sensingRadius *= 1 + 1e-12;
        version = -1;
    }

    private SensorCone createActualCone(int sensor) {
        SensorSignal signal = signals[sensor];
        return signal.changesOptics()
                ? new SensorCone(signal.faultySpec(), signal.specularAngle(), robot, maxTravel, MAX_TURN)
                : soundCones[sensor];
    }

    FaultSequence<Fault> faults(int sensor) {
        return signals[sensor].faults();
    }

    void setFaults(int sensor, FaultSequence<Fault> faults) {
        signals[sensor].setFaults(faults);
    }

    double truth(int sensor) {
        return truth[sensor];
    }

    double reported(int sensor) {
        return reported[sensor];
    }

    /** Copies all reported readings to an array. */
    void copyReported(double[] target) {
        System.arraycopy(reported, 0, target, 0, reported.length);
    }

    /**
     * Reads all sensors again between two ticks, so that snapshots show the effect of the commands since the last tick.
     * The next tick is not affected: in it the faults begin, remember and end as if there were no resampling.
     */
    void resample(ObstacleSet obstacles, RobotBody body, long tick) {
        SensorSignal[] lastSignals = signals;
        double[] lastReported = reported;
        signals = Arrays.stream(signals).map(SensorSignal::copy).toArray(SensorSignal[]::new);
        reported = reported.clone();
        sense(obstacles, body, tick);
        signals = lastSignals;
        reported = lastReported;
        configure(robot);
    }

    /** Reads all sensors, then lets their faults act: step 4 of a tick. */
    void sense(ObstacleSet obstacles, RobotBody body, long tick) {
        shown = reported;
        boolean exact = true;
        for (int i = 0; i < truth.length; i++) {
            if (signals[i].isExact()) {
                continue;
            }
            exact = false;
            if (signals[i].update(tick, dt, reported[i])) {
                actualCones[i] = createActualCone(i);
                version = -1;
            }
        }
        driven = distanceFromRegion(body);
        turned = Math.abs(body.heading() - regionHeading);
        if (version != obstacles.version() || !(driven < maxTravel && turned < MAX_TURN)) {
            collect(obstacles, body);
        }
        collectMoving(obstacles, body);
        if (!movingNear.isEmpty()) {
            wakeAll();
        }
        for (int i = 0; i < awakeCount; i++) {
            truth[awake[i]] = measure(soundCones[awake[i]], obstacles, body);
        }
        if (exact) {
            System.arraycopy(truth, 0, reported, 0, truth.length);
            return;
        }
        for (int i = 0; i < truth.length; i++) {
            boolean sound = actualCones[i] == soundCones[i];
            double seen = sound ? truth[i] : measure(actualCones[i], obstacles, body);
            reported[i] = signals[i].report(seen, truth[i + 1 < truth.length ? i + 1 : 0], tick);
        }
    }

    private void wakeAll() {
        awakeCount = truth.length;
        for (int i = 0; i < awakeCount; i++) {
            awake[i] = i;
        }
    }

    /**
     * Selects the sensors that may see something in the region. The others are not evaluated as long as no moving
     * obstacle is near.
     */
    private void wakeThoseThatMaySee() {
        awakeCount = 0;
        for (int i = 0; i < truth.length; i++) {
            if (soundCones[i].seesNothing()) {
                truth[i] = Reading.NOTHING;
            } else {
                awake[awakeCount++] = i;
            }
        }
    }

    private double distanceFromRegion(RobotBody body) {
        double dx = body.x() - regionX;
        double dy = body.y() - regionY;
        return Math.sqrt(dx * dx + dy * dy);
    }

    private void collect(ObstacleSet obstacles, RobotBody body) {
        version = obstacles.version();
        regionX = body.x();
        regionY = body.y();
        regionHeading = body.heading();
        regionCos = body.cos();
        regionSin = body.sin();
        driven = 0;
        turned = 0;
        double radius = 0;
        for (int i = 0; i < truth.length; i++) {
            soundCones[i].setHorizon(truth[i]);
            actualCones[i].setHorizon(truth[i]);
            radius = Math.max(radius, Math.max(soundCones[i].searchRadius(), actualCones[i].searchRadius()));
        }
        candidates.clear();
        obstacles.findStaticNear(regionX, regionY, radius, candidates);
        candidates.dropBeyond(regionX, regionY, radius);
        collectOutlines();
        for (int i = 0; i < truth.length; i++) {
            collect(soundCones[i], candidates);
            if (actualCones[i] != soundCones[i]) {
                collect(actualCones[i], candidates);
            }
        }
        wakeThoseThatMaySee();
    }

    private void collectOutlines() {
        outlinesNear.clear();
        plansNear.clear();
        double reach = outlineReach();
        for (int i = 0; i < candidates.size() && outsideRadius > 0; i++) {
            if (candidates.shape(i).distanceTo(regionX, regionY) <= reach) {
                outlinesNear.add(candidates.shape(i), candidates.owner(i));
            }
        }
    }

    /** Returns the greatest distance of an apex beside the body from the middle of the region, metres. */
    private double outlineReach() {
        return outsideRadius + maxTravel + MARGIN;
    }

    private void collect(SensorCone cone, CandidateBuffer shapes) {
        cone.collect(shapes, regionX, regionY, regionCos, regionSin);
    }

    private void collectMoving(ObstacleSet obstacles, RobotBody body) {
        movingNear.clear();
        List<MovingObstacle> moving = obstacles.moving();
        for (int i = 0; i < moving.size(); i++) {
            if (moving.get(i).isWithin(body.x(), body.y(), sensingRadius)) {
                movingNear.add(moving.get(i));
            }
        }
    }

    private double measure(SensorCone cone, ObstacleSet obstacles, RobotBody body) {
        if (cone.isOutsideBody() && isInsideSolid(new Vector2(cone.apexX(body), cone.apexY(body)), body)) {
            return 0;
        }
        double distance = cone.measure(body, driven, turned, movingNear);
        while (!cone.isCertain(distance)) {
            cone.widenHorizon();
            farCandidates.clear();
            obstacles.findStaticNear(regionX, regionY, cone.searchRadius(), farCandidates);
            collect(cone, farCandidates);
            distance = cone.measure(body, driven, turned, movingNear);
        }
        return distance;
    }

    /**
     * Returns whether an apex is inside a solid obstacle. The robot's centre is outside all obstacles, so the outline
     * of one that contains the apex comes between them.
     */
    private boolean isInsideSolid(Vector2 apex, RobotBody body) {
        for (int i = 0; i < outlinesNear.size(); i++) {
            if (outlinesNear.owner(i) instanceof PlacedObstacle obstacle
                    && isBetween(outlinesNear.shape(i), apex, body)
                    && contains(obstacle, apex)) {
                return true;
            }
        }
        return movingNear.stream().anyMatch(mover -> mover.geometry().contains(apex));
    }

    /**
     * Returns whether an obstacle contains an apex. All sides of a floor plan are looked at only once in the region.
     */
    private boolean contains(PlacedObstacle obstacle, Vector2 apex) {
        if (!(obstacle.obstacle().shape() instanceof ObstacleShape.PlanShape plan)) {
            return obstacle.geometry().contains(apex);
        }
        RigidMotion frame = obstacle.geometry().frame();
        Vector2 local = frame.toLocal(apex);
        return plansNear
                .computeIfAbsent(obstacle, owner -> plan.points()
                        .around(frame.toLocal(new Vector2(regionX, regionY)), outlineReach()))
                .contains(local.x(), local.y());
    }

    /** Returns whether a shape may come between the robot's centre and an apex. */
    private static boolean isBetween(ConvexShape shape, Vector2 apex, RobotBody body) {
        double dx = apex.x() - body.x();
        double dy = apex.y() - body.y();
        double length = Math.sqrt(dx * dx + dy * dy);
        RigidMotion middle = new RigidMotion(dx / length, dy / length, body.x() + dx / 2, body.y() + dy / 2);
        OrientedBox line = new OrientedBox(middle, length / 2 + MARGIN, MARGIN);
        return BoxDistance.between(line, shape).distance() == 0;
    }

    /** Returns all sensors as values, with the points where their cones' outlines meet obstacles' outlines. */
    List<SensorSnapshot> snapshots(ObstacleSet obstacles, RobotBody body) {
        RigidMotion frame = body.frame();
        CandidateBuffer shapes = new CandidateBuffer();
        obstacles.findNear(body.x(), body.y(), sensingRadius, shapes);
        List<SensorSnapshot> snapshots = new ArrayList<>();
        for (int i = 0; i < truth.length; i++) {
            SensorSpec spec = robot.sensors().get(i);
            Sector sector = soundCones[i].sector(frame);
            snapshots.add(new SensorSnapshot(
                    spec,
                    sector,
                    new Reading(truth[i]),
                    new Reading(shown[i]),
                    spec.on() ? intersections(shapes, sector) : List.of(),
                    signals[i].faults()));
        }
        return snapshots;
    }

    private static List<Vector2> intersections(CandidateBuffer shapes, Sector sector) {
        List<Vector2> hits = new ArrayList<>();
        for (int i = 0; i < shapes.size(); i++) {
            ShapeOwner owner = shapes.owner(i);
            hits.addAll(
                    owner.isSpecular() && shapes.shape(i) instanceof Segment segment
                            ? SpecularDistance.intersections(sector, segment, owner.specularAngle())
                            : SectorIntersections.points(sector, shapes.shape(i)));
        }
        return hits;
    }
}
