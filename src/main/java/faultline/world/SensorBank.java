package faultline.world;

import faultline.geometry.Convex;
import faultline.geometry.GlossyDistance;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistance;
import faultline.geometry.SectorOutline;
import faultline.geometry.Segment;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.sensor.Dice;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;

/** The robot's sensors at work: true and reported readings, tick by tick; mutable, on the world's thread. */
final class SensorBank {

    private final long seed;
    private final List<Mount> mounts = new ArrayList<>();
    private final Candidates near = new Candidates();
    private double[] truth = new double[0];
    private double[] reported = new double[0];
    private double reach;

    SensorBank(RobotSpec robot, long seed) {
        this.seed = seed;
        robot.sensors().forEach(sensor -> mounts.add(new Mount(sensor, Dice.stream(seed, sensor.id()))));
        truth = new double[mounts.size()];
        reported = new double[mounts.size()];
        refit(robot);
    }

    /** One sensor as mounted, its axis and cone as unit vectors in the robot's frame, and its faults. */
    private static final class Mount {
        private final long stream;
        private final List<Fault> faults = new ArrayList<>();
        private SensorSpec spec;
        private Vec axis;
        private double cosHalf;
        private double sinHalf;
        private boolean outside;

        Mount(SensorSpec spec, long stream) {
            this.stream = stream;
            this.spec = spec;
        }

        void fit(SensorSpec newSpec, RobotSpec robot) {
            spec = newSpec;
            axis = Vec.direction(spec.bearing());
            cosHalf = StrictMath.cos(spec.cone() / 2);
            sinHalf = StrictMath.sin(spec.cone() / 2);
            outside = Math.abs(spec.seat().x()) > robot.length() / 2 || Math.abs(spec.seat().y()) > robot.width() / 2;
        }

        Sector sector(Pose pose, double cos, double sin) {
            Vec seat = spec.seat();
            return new Sector(
                    pose.x() + cos * seat.x() - sin * seat.y(), pose.y() + sin * seat.x() + cos * seat.y(),
                    cos * axis.x() - sin * axis.y(), sin * axis.x() + cos * axis.y(), cosHalf, sinHalf, spec.range());
        }
    }

    /** Takes the sensors' and the platform's values anew after a change. */
    void refit(RobotSpec robot) {
        reach = 0;
        for (int i = 0; i < mounts.size(); i++) {
            SensorSpec spec = robot.sensors().get(i);
            mounts.get(i).fit(spec, robot);
            reach = Math.max(reach, spec.seat().length() + spec.range());
        }
    }

    List<Fault> faults(int sensor) {
        return mounts.get(sensor).faults;
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
    void sense(ObstacleField field, Pose pose, long tick) {
        double cos = StrictMath.cos(pose.heading());
        double sin = StrictMath.sin(pose.heading());
        near.clear();
        field.allNear(pose.x(), pose.y(), reach * (1 + 1e-12), near);
        for (int i = 0; i < truth.length; i++) {
            Mount mount = mounts.get(i);
            truth[i] = measure(field, mount, mount.sector(pose, cos, sin));
            reported[i] = report(mount, truth[i], tick);
        }
    }

    private double measure(ObstacleField field, Mount mount, Sector sector) {
        if (mount.outside && field.insideSolid(sector.apex())) {
            return 0;
        }
        double least = Reading.NOTHING;
        for (int i = 0; i < near.size(); i++) {
            least = Math.min(least, nearest(sector, near.figure(i), field.specular(near.owner(i))));
        }
        return least;
    }

    private static double nearest(Sector sector, Convex figure, double specular) {
        return specular < Obstacle.MATT && figure instanceof Segment segment
                ? GlossyDistance.nearest(sector, segment, specular) : SectorDistance.nearest(sector, figure);
    }

    private static double report(Mount mount, double truth, long tick) {
        SensorSpec spec = mount.spec;
        if (!spec.on()) {
            return Reading.OFF;
        }
        if (spec.noise() == 0 && mount.faults.isEmpty()) {
            return truth;
        }
        Dice dice = Dice.at(mount.stream, tick);
        double reading = noisy(truth, spec, dice);
        for (Fault fault : mount.faults) {
            if (Reading.isOff(reading)) {
                break;
            }
            reading = fault.distort(reading, spec.range(), dice);
        }
        return reading;
    }

    /** Noise adds to a distance, held at 0; beyond the range it reads as nothing. What sees nothing has no noise. */
    private static double noisy(double truth, SensorSpec spec, Dice dice) {
        double noise = spec.noise() * dice.gaussian();
        double reading = Math.max(0, truth + noise);
        return reading <= spec.range() ? reading : Reading.NOTHING;
    }

    /** All sensors as values, with the points where their cones' outlines meet what they can see of obstacles' outlines. */
    List<SensorSnapshot> snapshots(ObstacleField field, Pose pose) {
        double cos = StrictMath.cos(pose.heading());
        double sin = StrictMath.sin(pose.heading());
        near.clear();
        field.allNear(pose.x(), pose.y(), reach, near);
        List<SensorSnapshot> snapshots = new ArrayList<>();
        for (int i = 0; i < truth.length; i++) {
            Mount mount = mounts.get(i);
            Sector sector = mount.sector(pose, cos, sin);
            snapshots.add(new SensorSnapshot(mount.spec, sector, new Reading(truth[i]), new Reading(reported[i]),
                    mount.spec.on() ? hits(field, sector) : List.of(), mount.faults));
        }
        return snapshots;
    }

    private List<Vec> hits(ObstacleField field, Sector sector) {
        List<Vec> hits = new ArrayList<>();
        for (int i = 0; i < near.size(); i++) {
            hits.addAll(hits(sector, near.figure(i), field.specular(near.owner(i))));
        }
        return hits;
    }

    /** Of a glossy surface only what the sensor can see. */
    private static List<Vec> hits(Sector sector, Convex figure, double specular) {
        return specular < Obstacle.MATT && figure instanceof Segment segment
                ? GlossyDistance.hits(sector, segment, specular) : SectorOutline.hits(sector, figure);
    }
}
