package faultline.world;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorFaults;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import faultline.sensor.Fault;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** The live world, which executes steps 1, 3 and 4 of a tick. Mutable; belongs to one thread. */
public final class World {

    private final WorldSpec spec;
    private final double dt;
    private final ObstacleSet obstacleSet;
    private final RobotBody body;
    private final SensorArray sensors;
    private final MotionStep motionStep;
    private final CommandHandler commandHandler;
    private final double decay;
    private long tick;
    private boolean sensed;
    private final List<Collision> collisions = new ArrayList<>();
    private List<Vector2> contacts = List.of();

    /**
     * Thrown if a tick's contacts cannot be resolved: the robot turns by very many radians in it, or the tick or the
     * coordinates are so large that rounding hides where the robot touches something.
     */
    public static final class UnresolvedContactException extends RuntimeException {

        private static final long serialVersionUID = 1;

        UnresolvedContactException(String message) {
            super(message);
        }
    }

    /**
     * Creates a world at tick 0, before its first sensing.
     *
     * @param spec the obstacles at the start
     * @param robot the robot
     * @param start the robot's pose
     * @param dt the length of a tick, seconds
     * @param seed the seed of all random numbers
     */
    public World(WorldSpec spec, RobotSpec robot, Pose start, double dt, long seed) {
        this.spec = spec;
        this.dt = dt;
        this.obstacleSet = new ObstacleSet(spec);
        this.body = new RobotBody(robot, start);
        this.sensors = new SensorArray(robot, seed, dt);
        this.motionStep = new MotionStep(obstacleSet, body);
        this.commandHandler =
                new CommandHandler(spec, obstacleSet, body, sensors, motionStep, () -> sensed ? tick + 1 : 0);
        this.decay = robot.motor().decay(dt);
    }

    /** {@return an index of the static shapes at the start, the enclosing wall first} */
    public SpatialIndex startIndex() {
        return obstacleSet.startIndex().copy();
    }

    /**
     * Executes a command: step 1 of a tick. A refused command changes nothing.
     *
     * @param command the command
     * @return the inverse of the command, or why it was refused
     */
    public CommandResult execute(Command command) {
        CommandResult result = commandHandler.execute(command);
        motionStep.pollContact().ifPresent(contact -> recordCollision(contact, result.tick(), tick * dt));
        return result;
    }

    /**
     * Moves obstacles and robot by one tick and stops the robot at its first contact: step 3.
     *
     * @param leftVolts the voltage on the left motors
     * @param rightVolts the voltage on the right motors
     */
    public void move(double leftVolts, double rightVolts) {
        if (collisions.isEmpty()) {
            body.driveMotors(leftVolts, rightVolts, decay);
        }
        motionStep.move(dt);
        // A function that refers to this world would be an object for every tick.
        Optional<MotionStep.Contact> contact = motionStep.pollContact();
        if (contact.isPresent()) {
            recordCollision(contact.get(), tick + 1, tick * dt + contact.get().time());
        }
        tick++;
    }

    private void recordCollision(MotionStep.Contact contact, long at, double time) {
        contacts = contact.points();
        collisions.add(new Collision(
                body.middleOf(contacts), time, at, contact.obstacle(), activeFaults(), switchedOff(), motorFaults()));
    }

    private Map<String, List<Fault>> activeFaults() {
        Map<String, List<Fault>> faults = new TreeMap<>();
        for (int i = 0; i < body.spec().sensors().size(); i++) {
            if (!sensors.faults(i).isEmpty()) {
                faults.put(body.spec().sensors().get(i).id(), sensors.faults(i));
            }
        }
        return faults;
    }

    private List<String> switchedOff() {
        List<String> off = new ArrayList<>();
        body.spec().sensors().stream().filter(sensor -> !sensor.on()).forEach(sensor -> off.add(sensor.id()));
        return off;
    }

    /** Reads all sensors, then lets their faults act: step 4. */
    public void sense() {
        sensors.sense(obstacleSet, body, tick);
        sensed = true;
    }

    /**
     * Reads all sensors again, so that a snapshot between two ticks shows the effect of commands. Later ticks are not
     * affected.
     */
    public void resample() {
        sensors.resample(obstacleSet, body, tick);
    }

    /** {@return the number of ticks that have passed} */
    public long tick() {
        return tick;
    }

    /** {@return the robot with its current settings} */
    public RobotSpec robot() {
        return body.spec();
    }

    /** {@return the robot's pose; its heading is not normalised} */
    public Pose pose() {
        return body.pose();
    }

    /** {@return the robot's wheel speeds} */
    public WheelSpeeds wheelSpeeds() {
        return body.wheelSpeeds();
    }

    /**
     * {@return a sensor's reading without noise and faults, even if it is switched off; encoded as in
     * {@link faultline.sensor.Reading}}
     *
     * @param sensor the sensor's index in the robot's list
     */
    public double trueReading(int sensor) {
        return sensors.truth(sensor);
    }

    /**
     * {@return a sensor's reported reading; encoded as in {@link faultline.sensor.Reading}}
     *
     * @param sensor the sensor's index in the robot's list
     */
    public double reportedReading(int sensor) {
        return sensors.reported(sensor);
    }

    /**
     * {@return the active faults of a sensor, oldest first, in an immutable list}
     *
     * @param sensor its place in the robot's list
     */
    public List<Fault> faults(int sensor) {
        return sensors.faults(sensor);
    }

    /** {@return the active faults of the motors} */
    public MotorFaults motorFaults() {
        return body.motorFaults();
    }

    /** {@return all reported readings in a new array, encoded as in {@link faultline.sensor.Reading}} */
    public double[] reportedReadings() {
        double[] readings = new double[body.spec().sensors().size()];
        copyReportedReadings(readings);
        return readings;
    }

    /**
     * Copies all reported readings, encoded as in {@link faultline.sensor.Reading}, to an array of their number.
     *
     * @param target the array, as long as there are sensors
     */
    public void copyReportedReadings(double[] target) {
        sensors.copyReported(target);
    }

    /** {@return the robot's first collision, if there was one} */
    public Optional<Collision> collision() {
        return collisions.isEmpty() ? Optional.empty() : Optional.of(collisions.get(0));
    }

    /** {@return the obstacles at their current poses, in drawing order} */
    public List<Obstacle> obstacles() {
        return obstacleSet.obstacles();
    }

    /** {@return the current state as an immutable value} */
    public Snapshot snapshot() {
        return new Snapshot(
                tick,
                tick * dt,
                spec.width(),
                spec.height(),
                spec.enclosed(),
                body.spec(),
                body.pose(),
                body.wheelSpeeds(),
                body.motorFaults(),
                sensors.snapshots(obstacleSet, body),
                obstacles(),
                contacts,
                collisions);
    }
}
