package faultline.gui.document;

import faultline.engine.Journal;
import faultline.engine.Setup;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Clearance;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a scenario becomes by what was done to its run. Obstacles, platform, and the sensors' range and cone are the scenario's, and a
 * change of them is kept; switching a sensor and breaking it is what happens in one run, and is not.
 */
final class EditedSetup {

    private final Setup base;
    /** By id, empty where it was taken away: one that comes back, because that was undone, comes back to its place in the order. */
    private final Map<String, Optional<Obstacle>> obstacles = new LinkedHashMap<>();
    private RobotSpec robot;

    private EditedSetup(Setup base) {
        this.base = base;
        this.robot = base.robot();
        base.world().obstacles().forEach(obstacle -> obstacles.put(obstacle.id(), Optional.of(obstacle)));
    }

    /**
     * The setup after what was done to a run of it; whatever would leave the robot no room at its start is left as it was.
     *
     * @param journal what was done, and to which setup
     * @return the setup to begin anew with
     */
    static Setup of(Journal journal) {
        EditedSetup edited = new EditedSetup(journal.setup());
        journal.entries().forEach(entry -> edited.take(entry.command()));
        edited.makeRoom();
        return edited.setup();
    }

    /** Whether a scenario holds all that was done to a run of it. */
    static boolean keepsAll(Journal journal) {
        return journal.entries().stream().map(Journal.Entry::command).noneMatch(EditedSetup::isOfOneRun);
    }

    private static boolean isOfOneRun(Command command) {
        return command instanceof Command.SwitchSensor || command instanceof Command.InjectFault || command instanceof Command.ClearFault
                || command instanceof Command.ClearFaults;
    }

    private void take(Command command) {
        if (command instanceof Command.MoveObstacle move) {
            obstacles.computeIfPresent(move.obstacle(), (id, obstacle) -> obstacle.map(moved -> moved.at(move.pose())));
        } else if (command instanceof Command.PutObstacle put) {
            obstacles.put(put.obstacle().id(), Optional.of(put.obstacle()));
        } else if (command instanceof Command.RemoveObstacle remove) {
            obstacles.replace(remove.obstacle(), Optional.empty());
        } else if (command instanceof Command.SetPlatform platform) {
            robot = robot.withPlatform(platform.length(), platform.width(), platform.speed());
        } else if (command instanceof Command.TuneSensor tune) {
            robot = robot.withSensor(tuned(tune.sensor()));
        }
    }

    /** The switch stays as the scenario has it. */
    private SensorSpec tuned(SensorSpec wanted) {
        return wanted.withOn(robot.sensor(wanted.id()).map(SensorSpec::on).orElse(wanted.on()));
    }

    /** Takes back, one by one, what stands in the way at the start. */
    private void makeRoom() {
        Optional<String> obstructing = obstructing();
        while (obstructing.isPresent() && takeBack(obstructing.get())) {
            obstructing = obstructing();
        }
    }

    private Optional<String> obstructing() {
        return Clearance.obstructing(world(), robot, base.start());
    }

    private boolean takeBack(String id) {
        Optional<Obstacle> before = base.world().obstacles().stream().filter(obstacle -> obstacle.id().equals(id)).findFirst();
        if (obstacles.containsKey(id) && !before.equals(obstacles.get(id))) {
            obstacles.put(id, before);
            return true;
        }
        RobotSpec smaller = robot.withPlatform(base.robot().length(), base.robot().width(), robot.speed());
        boolean changed = !smaller.equals(robot);
        robot = smaller;
        return changed;
    }

    private WorldSpec world() {
        WorldSpec world = base.world();
        return new WorldSpec(world.width(), world.height(), world.enclosed(), world.maxMoving(),
                obstacles.values().stream().flatMap(Optional::stream).toList());
    }

    private Setup setup() {
        return new Setup(world(), robot, base.start(), base.controller(), base.timeline(), base.dt(), base.seed(), base.duration());
    }
}
