package faultline.gui.document;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Clearance;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * What a scenario becomes by what was done to its run. Obstacles, platform, and the sensors' range and cone are the
 * scenario's, and a change of them is kept; switching a sensor and breaking it is what happens in one run, and is not.
 */
final class SetupEditor implements Command.Visitor<Boolean> {

    private final SimulationSetup base;
    /**
     * By id, empty where it was taken away: one that comes back, because that was undone, comes back to its place in
     * the order.
     */
    private final Map<String, Optional<Obstacle>> obstacles = new LinkedHashMap<>();

    private RobotSpec robot;

    private SetupEditor(SimulationSetup base) {
        this.base = base;
        this.robot = base.robot();
        base.world().obstacles().forEach(obstacle -> obstacles.put(obstacle.id(), Optional.of(obstacle)));
    }

    /**
     * The setup after what was done to a run of it; whatever would leave the robot no room at its start is left as it
     * was.
     *
     * @param journal what was done, and to which setup
     * @return the setup to begin anew with
     */
    static SimulationSetup setupAfter(Journal journal) {
        SetupEditor edited = new SetupEditor(journal.setup());
        journal.entries().forEach(entry -> entry.command().accept(edited));
        edited.clearStartPose();
        return edited.setup();
    }

    /** Returns whether the scenario keeps every command of a journal. */
    static boolean coversAll(Journal journal) {
        SetupEditor edited = new SetupEditor(journal.setup());
        return journal.entries().stream().allMatch(entry -> entry.command().accept(edited));
    }

    @Override
    public Boolean visit(Command.SwitchSensor command) {
        return false;
    }

    @Override
    public Boolean visit(Command.ConfigureSensor command) {
        robot = robot.withSensor(withOriginalSwitch(command.sensor()));
        return true;
    }

    @Override
    public Boolean visit(Command.InjectFault command) {
        return false;
    }

    @Override
    public Boolean visit(Command.ClearFault command) {
        return false;
    }

    @Override
    public Boolean visit(Command.ClearFaults command) {
        return false;
    }

    @Override
    public Boolean visit(Command.MoveObstacle command) {
        obstacles.computeIfPresent(
                command.obstacle(), (id, obstacle) -> obstacle.map(moved -> moved.withPose(command.pose())));
        return true;
    }

    @Override
    public Boolean visit(Command.PlaceObstacle command) {
        obstacles.put(command.obstacle().id(), Optional.of(command.obstacle()));
        return true;
    }

    @Override
    public Boolean visit(Command.RemoveObstacle command) {
        obstacles.replace(command.obstacle(), Optional.empty());
        return true;
    }

    @Override
    public Boolean visit(Command.SetPlatform command) {
        robot = robot.withPlatform(command.length(), command.width(), command.speed());
        return true;
    }

    /** The switch stays as the scenario has it. */
    private SensorSpec withOriginalSwitch(SensorSpec wanted) {
        return wanted.withOn(robot.sensor(wanted.id()).map(SensorSpec::on).orElse(wanted.on()));
    }

    /** Takes back, one by one, what stands in the way at the start. */
    private void clearStartPose() {
        Optional<String> obstructing = findObstruction();
        while (obstructing.isPresent() && revertChange(obstructing.get())) {
            obstructing = findObstruction();
        }
    }

    private Optional<String> findObstruction() {
        return Clearance.findObstruction(world(), robot, base.start());
    }

    private boolean revertChange(String id) {
        Optional<Obstacle> before = base.world().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(id))
                .findFirst();
        if (obstacles.containsKey(id) && !before.equals(obstacles.get(id))) {
            obstacles.put(id, before);
            return true;
        }
        RobotSpec smaller =
                robot.withPlatform(base.robot().length(), base.robot().width(), robot.speed());
        boolean changed = !smaller.equals(robot);
        robot = smaller;
        return changed;
    }

    private WorldSpec world() {
        return base.world()
                .withObstacles(
                        obstacles.values().stream().flatMap(Optional::stream).toList());
    }

    private SimulationSetup setup() {
        return base.withWorld(world()).withRobot(robot);
    }
}
