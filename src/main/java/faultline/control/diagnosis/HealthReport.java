package faultline.control.diagnosis;

import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.robot.RobotSpec;
import java.util.ArrayList;
import java.util.List;

/** The health of all sensors for display: a list that is replaced only if something in it changes. */
final class HealthReport {

    /** A sensor with this much evidence against it is suspected. */
    private static final double SUSPICIOUS = 0.5;

    /** A suspected sensor with no more evidence than this, in whole tenths, is trusted again. */
    private static final double HARMLESS = 0.3;

    private final double[] shares;
    private List<SensorHealth> health;

    HealthReport(RobotSpec robot) {
        shares = new double[robot.sensors().size()];
        health = robot.sensors().stream()
                .map(sensor -> SensorHealth.trusted(sensor.id()))
                .toList();
    }

    /**
     * Reports a sensor.
     *
     * @param sensor the sensor
     * @param assessment the assessment of all sensors
     * @param tick now
     */
    void update(int sensor, TrustAssessment assessment, long tick) {
        SensorFinding finding = assessment.finding(sensor);
        double share = assessment.evidence(sensor);
        SensorHealth before = health.get(sensor);
        if (share == shares[sensor] && finding == before.finding()) {
            return;
        }
        shares[sensor] = share;
        double evidence = Math.min(10, Math.floor(10 * share)) / 10;
        if (before.finding() != finding || before.evidence() != evidence) {
            SensorTrust trust = trust(before.trust(), finding, evidence);
            List<SensorHealth> fresh = new ArrayList<>(health);
            long since = trust == before.trust() ? before.sinceTick() : tick;
            fresh.set(sensor, new SensorHealth(before.sensor(), trust, finding, evidence, since));
            health = List.copyOf(fresh);
        }
    }

    private static SensorTrust trust(SensorTrust before, SensorFinding finding, double evidence) {
        if (finding != SensorFinding.NONE) {
            return SensorTrust.DISTRUSTED;
        }
        boolean suspected = before == SensorTrust.SUSPECTED ? evidence > HARMLESS : evidence >= SUSPICIOUS;
        return suspected ? SensorTrust.SUSPECTED : SensorTrust.TRUSTED;
    }

    /** Returns the health of all sensors in the robot's order. */
    List<SensorHealth> all() {
        return health;
    }
}
