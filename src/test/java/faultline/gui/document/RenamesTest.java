package faultline.gui.document;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.gui.change.Rename;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** A tree is called oak later, and a sensor has several names in turn. */
class RenamesTest {

    private static final List<String> SENSORS = List.of("front", "left");
    private static final Rename TO_OAK = Rename.ofObstacle("tree", "oak");

    private final Renames renames = new Renames();

    @Test
    void anIdOfASensorIsFoundInAnEarlierAndInALaterRobot() {
        renames.add(Rename.ofSensor("left", "port"));
        renames.add(Rename.ofSensor("port", "left"));
        renames.add(Rename.ofSensor("left", "larboard"));
        for (String id : List.of("left", "port", "larboard")) {
            assertEquals("larboard", renames.presentId(id, List.of("front", "larboard")));
            assertEquals("left", renames.presentId(id, List.of("front", "left")));
            assertEquals("port", renames.presentId(id, List.of("front", "port")));
            assertEquals(id, renames.presentId(id, List.of("front")), "removed");
        }
        assertEquals("front", renames.presentId("front", List.of("front", "larboard")));
        renames.add(Rename.ofSensor("rear", "left"));
        renames.add(Rename.ofSensor("left", "rear"));
        assertEquals("rear", renames.presentId("left", List.of("larboard", "rear")), "the last one with this id");
    }

    @Test
    void aSensorIsFollowedAlthoughAnotherOneGetsItsId() {
        renames.add(Rename.ofSensor("rear", "left"));
        Supplier<String> left = renames.followSensor("left");
        assertEquals("left", left.get());
        renames.add(Rename.ofSensor("left", "port"));
        renames.add(Rename.ofSensor("front", "left"));
        assertEquals("port", left.get());
    }

    @Test
    void theRunHasEarlierIdsOfObstaclesUntilItIsReplayed() {
        renames.add(TO_OAK);
        assertEquals(remove("oak"), renames.ofRun(remove("tree"), SENSORS));
        assertEquals(executed(remove("oak")), renames.ofRun(executed(remove("tree")), SENSORS));
        assertEquals(remove("tree"), renames.inRun(remove("oak"), 1, SENSORS));
        assertEquals(remove("tree"), renames.inRun(remove("tree"), 0, SENSORS), "sent before the change");
        renames.journalMade();
        assertEquals(remove("tree"), renames.inRun(remove("oak"), 1, SENSORS), "not replayed yet");
        renames.journalReplayed();
        assertEquals(remove("oak"), renames.ofRun(remove("oak"), SENSORS));
        assertEquals(remove("oak"), renames.inRun(remove("oak"), 1, SENSORS));
        assertEquals(remove("oak"), renames.inRun(remove("tree"), 0, SENSORS), "sent before the change");
    }

    @Test
    void aCommandToTheRunHasTheIdOfTheSensorThere() {
        renames.add(Rename.ofSensor("left", "port"));
        assertEquals(switchOff("left"), renames.inRun(switchOff("port"), 0, SENSORS));
        assertEquals(switchOff("port"), renames.ofRun(switchOff("left"), List.of("front", "port")));
        assertEquals(executed(switchOff("port")), renames.ofRun(executed(switchOff("left")), List.of("front", "port")));
    }

    @Test
    void theViewsTakeTheIdsThatTheRunHas() {
        renames.add(TO_OAK);
        assertEquals("oak", renames.ofViews("tree"));
        assertEquals("tree", renames.ofViews("oak"), "a removed obstacle that had the id");
        assertEquals(remove("oak"), renames.ofViews(remove("tree")));
        assertEquals(Optional.empty(), renames.takeForViews(), "the run does not have it yet");
        renames.journalMade();
        renames.journalReplayed();
        assertEquals("oak", renames.takeForViews().orElseThrow().apply("tree"));
        assertEquals(Optional.empty(), renames.takeForViews());
        assertEquals("oak", renames.ofViews("oak"));
    }

    @Test
    void aJournalOfTheRunGetsTheIdsOfTheLastOne() {
        Journal ofRun = new Journal(forest("tree"), List.of(new Journal.Entry(3, remove("tree"))), 9);
        renames.add(TO_OAK);
        renames.journalMade();
        renames.add(Rename.ofObstacle("oak", "elm"));
        assertEquals(
                new Journal(forest("oak"), List.of(new Journal.Entry(3, remove("oak"))), 9), renames.inJournal(ofRun));
        renames.journalReplayed();
        assertEquals(ofRun, renames.inJournal(ofRun));
    }

    @Test
    void resultsFollowOnlyTheChangesAfterThem() {
        renames.add(Rename.ofObstacle("elm", "tree"));
        Supplier<List<CommandResult>> followed =
                renames.follow(List.of(executed(remove("tree")), executed(remove("elm")), executed(switchOff("left"))));
        renames.add(TO_OAK);
        renames.add(Rename.ofSensor("left", "port"));
        assertEquals(
                List.of(executed(remove("oak")), executed(remove("elm")), executed(switchOff("port"))), followed.get());
    }

    @Test
    void aRestartGivesTheRunAllIdsAndTheViewsNone() {
        renames.add(TO_OAK);
        renames.add(Rename.ofSensor("left", "port"));
        Renames restarted = new Renames();
        restarted.continueFrom(renames);
        assertEquals(1, restarted.changesOfObstacles());
        assertEquals(remove("oak"), restarted.ofRun(remove("oak"), SENSORS));
        assertEquals("oak", restarted.ofViews("tree"));
        assertEquals("port", restarted.presentId("left", List.of("port")));
        assertEquals("oak", restarted.takeForViews().orElseThrow().apply("tree"));
    }

    @Test
    void anEarlierCommandIsAboutTheObstacleThatIsThere() {
        renames.add(TO_OAK);
        renames.add(Rename.ofSensor("port", "left"));
        assertEquals(remove("oak"), renames.presentCommand(remove("tree"), forest("oak")));
        assertEquals(remove("elm"), renames.presentCommand(remove("elm"), forest("oak")), "not there");
        assertEquals(switchOff("left"), renames.presentCommand(switchOff("port"), forest("oak")));
    }

    private static SimulationSetup forest(String id) {
        Obstacle tree = new Obstacle(id, new ObstacleShape.CircleShape(0.1), new Pose(2, 3, 0));
        return SimulationSetup.of(new WorldSpec(6, 4, true, 3, List.of(tree)), new Pose(1, 1, 0));
    }

    private static Command remove(String id) {
        return new Command.RemoveObstacle(id);
    }

    private static Command switchOff(String id) {
        return new Command.SwitchSensor(id, false);
    }

    private static CommandResult executed(Command command) {
        return new CommandResult.Executed(1, command, List.of());
    }
}
