package faultline.control.fallback;

import faultline.control.diagnosis.DeadReckoning;
import faultline.control.diagnosis.EvidenceGrid;
import faultline.control.diagnosis.MountedCone;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.geometry.Angles;
import faultline.robot.RobotSpec;

/**
 * How far the path is known to be free, and the scans that show more of it. Directions are in radians in the frame of
 * the map.
 */
final class KnownPath {

    /** The length of the path that is examined, metres. */
    private static final double EXAMINED = 0.6;

    /** The length of the path that must be known to drive on, metres. */
    private static final double TO_DRIVE = 0.06;

    /** The length of the path that must be known to end a scan, metres. */
    private static final double TO_END_SCAN = 0.18;

    /** The length that must be known behind the robot to drive backwards, metres. */
    private static final double TO_RETREAT = TO_DRIVE / 2;

    /** A sensor whose axis is farther than this from the direction of motion faces sideways, radians. */
    private static final double SIDEWAYS = StrictMath.toRadians(60);

    /**
     * A scan by a sensor that faces sideways also shows the path in a direction that is this far clockwise, radians:
     * when the robot has turned back, the wall is seen again and the direction changes a little (decision 0038).
     */
    private static final double SCAN_MARGIN = StrictMath.toRadians(20);

    private final SensorDiagnosis diagnosis;
    private final DeadReckoning at;
    private final FreeDirectionFinder finder;
    private final Scan scan = new Scan();

    KnownPath(SensorDiagnosis diagnosis, FreeDirectionFinder finder) {
        this.diagnosis = diagnosis;
        this.at = diagnosis.reckoning();
        this.finder = finder;
    }

    /** Ends a scan. */
    void endScan() {
        scan.end();
    }

    /** Returns whether the robot must turn, because too little of its path is known. */
    boolean isScanning() {
        return scan.isActive();
    }

    /** Returns the direction of the turn of a scan, 1 if it is counter-clockwise, otherwise -1. */
    double scanSign() {
        return scan.sign();
    }

    /**
     * Ends a scan if enough of the path is known, or starts one if too little is.
     *
     * @param robot the robot
     * @param direction of the path
     * @param driving how the robot drives along it
     */
    void update(RobotSpec robot, double direction, DriveDirection driving) {
        double known = known(robot, direction);
        if (scan.isActive()) {
            if (known >= TO_END_SCAN && known(robot, direction - scan.margin()) >= TO_DRIVE) {
                scan.end();
            }
        } else if (known < TO_DRIVE) {
            startScan(driving);
        } else {
            scan.forget();
        }
    }

    /**
     * Adds the last turn of the robot to a scan. When its place has been seen, the scan ends, or continues if another
     * place is still unknown.
     *
     * @param robot the robot
     * @param direction of the path
     * @param driving how the robot drives along it
     */
    void advanceScan(RobotSpec robot, double direction, DriveDirection driving) {
        if (!scan.advance(at.turned())) {
            return;
        }
        scan.end();
        double known = known(robot, direction);
        if (known >= TO_DRIVE) {
            return;
        }
        if (scan.mayContinueAt(finder.unknownX(), finder.unknownY())) {
            startScan(driving);
            return;
        }
        // Everything visible has been seen, so unknown places now count as surfaces.
        double far = known + Steering.turningRadius(robot);
        diagnosis.markUnseen(at.x() + far * StrictMath.cos(direction), at.y() + far * StrictMath.sin(direction));
        diagnosis.markUnseen(finder.unknownX(), finder.unknownY());
    }

    private double known(RobotSpec robot, double direction) {
        return finder.known(at, direction, EXAMINED, robot.length() / 2, robot.width() / 2);
    }

    /**
     * Returns whether the ground behind the robot is known to be free. The robot has come from there, so the ground
     * that its body covered is known, except for the cells at the border.
     */
    boolean isBehindFree(RobotSpec robot) {
        double back = at.heading() + StrictMath.PI;
        double half = robot.width() / 2 - EvidenceGrid.CELL;
        return finder.known(at, back, TO_DRIVE, robot.length() / 2, half) >= TO_RETREAT;
    }

    /** Turns until the trusted sensor that needs to turn least has seen the nearest unknown place of the path. */
    private void startScan(DriveDirection driving) {
        double best = Double.NaN;
        double margin = 0;
        for (int i = 0; i < diagnosis.sensors(); i++) {
            if (diagnosis.isTrusted(i)) {
                double turn = turnFor(diagnosis.cone(i), finder.unknownX(), finder.unknownY());
                if (Double.isNaN(best) || Math.abs(turn) < Math.abs(best)) {
                    best = turn;
                    margin = isSideways(diagnosis.cone(i), driving) ? SCAN_MARGIN : 0;
                }
            }
        }
        scan.start(best, margin, finder.unknownX(), finder.unknownY());
    }

    private static boolean isSideways(MountedCone cone, DriveDirection driving) {
        return Math.abs(Angles.difference(driving.leading(0), cone.bearing())) > SIDEWAYS;
    }

    /** Returns the angle to turn until a cone's axis points at a place. */
    private double turnFor(MountedCone cone, double px, double py) {
        double bearing = StrictMath.atan2(py - at.y(), px - at.x());
        return Angles.difference(at.heading() + cone.bearing(), bearing);
    }
}
