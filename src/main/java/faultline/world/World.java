package faultline.world;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** The live world: steps 1 and 3 to 6 of a tick. Mutable; belongs to one thread. */
public final class World {

    private final WorldSpec spec;
    private final double dt;
    private final ObstacleField field;
    private final RobotBody body;
    private final SensorBank sensors;
    private final Traffic traffic;
    private final CommandDesk desk;
    private final CommandUndo undo;
    private final double decay;
    private long tick;
    private Optional<Collision> collision = Optional.empty();
    private List<Vec> contacts = List.of();

    /**
     * A world at tick 0, before its first sensing.
     *
     * @param spec the obstacles before anything moves
     * @param robot as built
     * @param start the robot's pose
     * @param dt the length of a tick, seconds
     * @param seed of all random numbers
     */
    public World(WorldSpec spec, RobotSpec robot, Pose start, double dt, long seed) {
        this.spec = spec;
        this.dt = dt;
        this.field = new ObstacleField(spec);
        this.body = new RobotBody(robot, start);
        this.sensors = new SensorBank(robot, seed);
        this.traffic = new Traffic(field, body);
        this.desk = new CommandDesk(spec, field, body, sensors, traffic);
        this.undo = new CommandUndo(field, body, sensors);
        this.decay = robot.motor().decay(dt);
    }

    /**
     * What would take a command back.
     *
     * @param command that is not applied yet
     * @return the commands, in order, that restore what it is about to change; a collision that it brings about stays. Empty where it will
     *         be refused because it names something unknown
     */
    public List<Command> undoing(Command command) {
        return undo.of(command);
    }

    /**
     * Applies a command: step 1 of a tick.
     *
     * @param command what is to be done
     * @return why it was refused, empty where it was done
     */
    public Optional<String> apply(Command command) {
        Optional<String> refusal = desk.apply(command);
        traffic.takeContact().ifPresent(contact -> collide(contact, tick, tick * dt));
        return refusal;
    }

    /**
     * Moves obstacles and robot by one tick and stops the robot at its first contact: steps 3 to 5.
     *
     * @param leftVolts on the left motors
     * @param rightVolts on the right motors
     */
    public void move(double leftVolts, double rightVolts) {
        if (collision.isEmpty()) {
            body.driveMotors(leftVolts, rightVolts, decay);
        }
        traffic.move(dt);
        traffic.takeContact().ifPresent(contact -> collide(contact, tick + 1, tick * dt + contact.time()));
        tick++;
    }

    private void collide(Traffic.Contact contact, long at, double time) {
        if (collision.isPresent()) {
            return;
        }
        contacts = contact.points();
        collision = Optional.of(new Collision(middle(contacts), time, at, contact.obstacle(), faults(), switchedOff()));
    }

    private static Vec middle(List<Vec> points) {
        Vec sum = points.stream().reduce(Vec.ZERO, Vec::plus);
        return sum.times(1.0 / points.size());
    }

    private Map<String, List<Fault>> faults() {
        Map<String, List<Fault>> faults = new TreeMap<>();
        for (int i = 0; i < body.spec().sensors().size(); i++) {
            if (!sensors.faults(i).isEmpty()) {
                faults.put(body.spec().sensors().get(i).id(), List.copyOf(sensors.faults(i)));
            }
        }
        return faults;
    }

    private List<String> switchedOff() {
        List<String> off = new ArrayList<>();
        body.spec().sensors().stream().filter(sensor -> !sensor.on()).forEach(sensor -> off.add(sensor.id()));
        return off;
    }

    /** Reads all sensors, then lets their faults act: step 6. */
    public void sense() {
        sensors.sense(field, body.pose(), tick);
    }

    /**
     * How many ticks have passed.
     *
     * @return from 0
     */
    public long tick() {
        return tick;
    }

    /**
     * The robot as it is built and set now.
     *
     * @return a value
     */
    public RobotSpec robot() {
        return body.spec();
    }

    /**
     * The robot's pose.
     *
     * @return its heading is not normalised
     */
    public Pose pose() {
        return body.pose();
    }

    /**
     * The speed of the left wheels.
     *
     * @return metres per second
     */
    public double leftSpeed() {
        return body.leftSpeed();
    }

    /**
     * The speed of the right wheels.
     *
     * @return metres per second
     */
    public double rightSpeed() {
        return body.rightSpeed();
    }

    /**
     * What a sensor would read without noise and faults, switched on or not.
     *
     * @param sensor its place in the robot's list
     * @return encoded as in {@link faultline.sensor.Reading}
     */
    public double trueReading(int sensor) {
        return sensors.truth(sensor);
    }

    /**
     * What a sensor reports.
     *
     * @param sensor its place in the robot's list
     * @return encoded as in {@link faultline.sensor.Reading}
     */
    public double reportedReading(int sensor) {
        return sensors.reported(sensor);
    }

    /**
     * What all sensors report.
     *
     * @return a fresh array in the robot's order, encoded as in {@link faultline.sensor.Reading}
     */
    public double[] reportedReadings() {
        return sensors.reported();
    }

    /**
     * The robot's first contact.
     *
     * @return empty before it
     */
    public Optional<Collision> collision() {
        return collision;
    }

    /**
     * Everything as an immutable value.
     *
     * @return the world now
     */
    public Snapshot snapshot() {
        return new Snapshot(tick, tick * dt, spec.width(), spec.height(), spec.enclosed(), body.spec(), body.pose(),
                body.leftSpeed(), body.rightSpeed(), sensors.snapshots(field, body.pose()), field.obstacles(), contacts, collision);
    }
}
