package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistance;
import faultline.geometry.SectorIntersections;
import faultline.geometry.Segment;
import faultline.geometry.SpecularDistance;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import faultline.sensor.SensorRandom;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;

/** The robot's sensors at work: true and reported readings, tick by tick; mutable, on the world's thread. */
final class SensorArray {

    private final double dt;
    private final List<MountedSensor> mountedSensors = new ArrayList<>();
    private final CandidateBuffer candidates = new CandidateBuffer();
    private double[] truth = new double[0];
    private double[] reported = new double[0];
    private double sensingRadius;

    SensorArray(RobotSpec robot, long seed, double dt) {
        this.dt = dt;
        robot.sensors()
                .forEach(sensor ->
                        mountedSensors.add(new MountedSensor(sensor, SensorRandom.streamKey(seed, sensor.id()))));
        truth = new double[mountedSensors.size()];
        reported = new double[mountedSensors.size()];
        configure(robot);
    }

    /** One sensor as mounted, its axis and cone as unit vectors in the robot's frame, and its faults. */
    private static final class MountedSensor {
        private final long streamKey;
        private final List<Fault> faults = new ArrayList<>();
        private final ActiveFaults active = new ActiveFaults();
        private SensorSpec spec;
        private RigidMotion frame;
        private double cosHalf;
        private double sinHalf;
        private boolean outsideBody;

        MountedSensor(SensorSpec spec, long stream) {
            this.streamKey = stream;
            this.spec = spec;
        }

        void configure(SensorSpec newSpec, RobotSpec robot) {
            spec = newSpec;
            frame = RigidMotion.of(
                    new Pose(spec.mountPosition().x(), spec.mountPosition().y(), spec.bearing()));
            cosHalf = StrictMath.cos(spec.cone() / 2);
            sinHalf = StrictMath.sin(spec.cone() / 2);
            outsideBody = Math.abs(spec.mountPosition().x()) > robot.length() / 2
                    || Math.abs(spec.mountPosition().y()) > robot.width() / 2;
        }

        Sector sector(RigidMotion robot) {
            return new Sector(robot.after(frame), cosHalf, sinHalf, spec.range());
        }
    }

    /** Takes the sensors' and the platform's values anew after a change. */
    void configure(RobotSpec robot) {
        sensingRadius = 0;
        for (int i = 0; i < mountedSensors.size(); i++) {
            SensorSpec spec = robot.sensors().get(i);
            mountedSensors.get(i).configure(spec, robot);
            sensingRadius = Math.max(sensingRadius, spec.mountPosition().length() + spec.range());
        }
    }

    List<Fault> faults(int sensor) {
        return mountedSensors.get(sensor).faults;
    }

    double truth(int sensor) {
        return truth[sensor];
    }

    double reported(int sensor) {
        return reported[sensor];
    }

    /** What all sensors report, as an array of its own. */
    double[] reported() {
        return reported.clone();
    }

    /** Senses, then lets the faults act: step 6 of a tick. */
    void sense(ObstacleSet field, Pose pose, long tick) {
        RigidMotion robot = RigidMotion.of(pose);
        candidates.clear();
        field.findNear(pose.x(), pose.y(), sensingRadius * (1 + 1e-12), candidates);
        for (int i = 0; i < truth.length; i++) {
            MountedSensor mount = mountedSensors.get(i);
            truth[i] = measure(field, mount, mount.sector(robot), Obstacle.MATT);
        }
        for (int i = 0; i < truth.length; i++) {
            MountedSensor mount = mountedSensors.get(i);
            mount.active.update(mount.faults, tick, dt, reported[i]);
            reported[i] = report(mount, seen(field, mount, robot, i), truth[(i + 1) % truth.length], tick);
        }
    }

    /** Returns what a sensor sees through its optics, faults included. */
    private double seen(ObstacleSet field, MountedSensor mount, RigidMotion robot, int sensor) {
        if (!mount.active.changesOptics()) {
            return truth[sensor];
        }
        SensorSpec optics = mount.active.optics(mount.spec);
        RigidMotion frame = RigidMotion.of(
                new Pose(optics.mountPosition().x(), optics.mountPosition().y(), optics.bearing()));
        Sector sector = new Sector(
                robot.after(frame),
                StrictMath.cos(optics.cone() / 2),
                StrictMath.sin(optics.cone() / 2),
                optics.range());
        return measure(field, mount, sector, mount.active.specularAngle());
    }

    private double measure(ObstacleSet field, MountedSensor mount, Sector sector, double specularLimit) {
        if (mount.outsideBody && field.isInsideSolid(sector.apex())) {
            return 0;
        }
        double least = Reading.NOTHING;
        for (int i = 0; i < candidates.size(); i++) {
            least = Math.min(
                    least,
                    nearestDistance(
                            sector,
                            candidates.shape(i),
                            Math.min(specularLimit, field.specularAngle(candidates.owner(i)))));
        }
        return least;
    }

    private static double nearestDistance(Sector sector, ConvexShape figure, double specular) {
        return specular < Obstacle.MATT && figure instanceof Segment segment
                ? SpecularDistance.nearest(sector, segment, specular)
                : SectorDistance.nearest(sector, figure);
    }

    private static double report(MountedSensor mount, double seen, double neighbour, long tick) {
        SensorSpec spec = mount.spec;
        if (!spec.on()) {
            return Reading.OFF;
        }
        if (spec.noise() == 0 && mount.faults.isEmpty()) {
            return seen;
        }
        SensorRandom dice = SensorRandom.forTick(mount.streamKey, tick);
        double reading = addNoise(seen, spec, dice);
        return mount.active.apply(reading, tick, spec.range(), neighbour, dice);
    }

    /** Noise adds to a distance, held at 0; beyond the range it reads as nothing. What sees nothing has no noise. */
    private static double addNoise(double truth, SensorSpec spec, SensorRandom dice) {
        double noise = spec.noise() * dice.nextGaussian();
        double reading = Math.max(0, truth + noise);
        return reading <= spec.range() ? reading : Reading.NOTHING;
    }

    /**
     * All sensors as values, with the points where their cones' outlines meet what they can see of obstacles' outlines.
     */
    List<SensorSnapshot> snapshots(ObstacleSet field, Pose pose) {
        RigidMotion robot = RigidMotion.of(pose);
        candidates.clear();
        field.findNear(pose.x(), pose.y(), sensingRadius, candidates);
        List<SensorSnapshot> snapshots = new ArrayList<>();
        for (int i = 0; i < truth.length; i++) {
            MountedSensor mount = mountedSensors.get(i);
            Sector sector = mount.sector(robot);
            snapshots.add(new SensorSnapshot(
                    mount.spec,
                    sector,
                    new Reading(truth[i]),
                    new Reading(reported[i]),
                    mount.spec.on() ? intersections(field, sector) : List.of(),
                    mount.faults));
        }
        return snapshots;
    }

    private List<Vector2> intersections(ObstacleSet field, Sector sector) {
        List<Vector2> hits = new ArrayList<>();
        for (int i = 0; i < candidates.size(); i++) {
            hits.addAll(intersections(sector, candidates.shape(i), field.specularAngle(candidates.owner(i))));
        }
        return hits;
    }

    /** Of a glossy surface only what the sensor can see. */
    private static List<Vector2> intersections(Sector sector, ConvexShape figure, double specular) {
        return specular < Obstacle.MATT && figure instanceof Segment segment
                ? SpecularDistance.intersections(sector, segment, specular)
                : SectorIntersections.points(sector, figure);
    }
}
