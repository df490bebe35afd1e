package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Commands of a timeline as items, and edits of items as commands. */
class TimelineModelTest {

    /** The length of a tick, seconds. */
    private static final double DT = 0.01;

    private static final double END_OF_RUN = Double.POSITIVE_INFINITY;
    private static final Fault STUCK = new Fault.Stuck(0.3);
    private static final Fault DEAD = new Fault.Dead();

    private static TimedCommand inject(double time, String sensor, Fault fault) {
        return new TimedCommand(time, new Command.InjectFault(sensor, fault));
    }

    private static TimedCommand clear(double time, String sensor, Fault fault) {
        return new TimedCommand(time, new Command.ClearFault(sensor, fault));
    }

    private static TimedCommand clearAll(double time, String sensor) {
        return new TimedCommand(time, new Command.ClearFaults(sensor));
    }

    private static TimedCommand turn(double time, String sensor, boolean on) {
        return new TimedCommand(time, new Command.SwitchSensor(sensor, on));
    }

    private static TimedCommand move(double time) {
        return new TimedCommand(time, new Command.MoveObstacle("desk", new Pose(1, 2, 0)));
    }

    private static List<String> spans(List<TimedCommand> commands) {
        return TimelineModel.of(commands, DT).items().stream()
                .map(item -> item.lane().label() + " " + item.start() + " " + item.end())
                .toList();
    }

    @Test
    void aFaultAndItsRemovalAreOneItemWhereverTheyStandInTheFile() {
        List<TimedCommand> commands =
                List.of(clear(8, "left", STUCK), inject(9, "front", DEAD), move(3), inject(2, "left", STUCK));
        assertEquals(List.of("left 2.0 8.0", "other 3.0 3.0", "front 9.0 Infinity"), spans(commands));
    }

    /** As in the run, which executes the commands of a tick in the order of the file, whatever their times are. */
    @Test
    void theTimesOfOneTickAreInTheOrderOfTheFile() {
        assertEquals(
                List.of("left 10.004 10.004"),
                spans(List.of(inject(10.004, "left", DEAD), clear(10.002, "left", DEAD))));
        List<TimedCommand> reversed = List.of(clear(10.004, "left", DEAD), inject(10.002, "left", DEAD));
        assertEquals(List.of("left 10.004 10.004", "left 10.002 Infinity"), spans(reversed));
        TimelineModel switched = TimelineModel.of(List.of(turn(5, "left", false), turn(10.004, "left", true)), DT);
        assertEquals(
                List.of("left 5.0 10.004", "left 10.002 Infinity"),
                spans(switched.with(TimelineItem.from(new Command.SwitchSensor("left", false), 10.002))));
    }

    @Test
    void aRemovalEndsTheOldestEqualFaultAsTheWorldDoes() {
        List<TimedCommand> commands = List.of(
                inject(1, "left", STUCK), inject(2, "left", DEAD), inject(3, "left", STUCK), clear(4, "left", STUCK));
        assertEquals(List.of("left 1.0 4.0", "left 2.0 Infinity", "left 3.0 Infinity"), spans(commands));
    }

    private static TimedCommand randomFaultOrRemoval(double time, Random random) {
        Fault fault = random.nextBoolean() ? STUCK : DEAD;
        return switch (random.nextInt(8)) {
            case 0 -> clearAll(time, "left");
            case 1, 2, 3 -> clear(time, "left", fault);
            default -> inject(time, "left", fault);
        };
    }

    /** Returns the items of one sensor's commands, found with a list of all items so far. */
    private static List<TimelineItem> itemsInList(List<TimedCommand> commands) {
        List<TimelineItem> items = new ArrayList<>();
        for (TimedCommand timed : commands) {
            Command command = timed.command();
            boolean endsAll = command instanceof Command.ClearFaults;
            boolean ends = false;
            for (int i = 0; i < items.size() && (endsAll || !ends); i++) {
                TimelineItem item = items.get(i);
                if (item.isOpen() && (endsAll || item.endings().get(0).equals(command))) {
                    items.set(i, item.withTimes(item.start(), timed.time()));
                    ends = true;
                }
            }
            if (!ends) {
                items.add(TimelineItem.from(command, timed.time()));
            }
        }
        return items;
    }

    @Test
    void theItemsAreThoseOfAListWhoseFirstOfEqualFaultsEnds() {
        Random random = new Random(4);
        for (int run = 0; run < 300; run++) {
            List<TimedCommand> commands = IntStream.range(0, 40)
                    .mapToObj(time -> randomFaultOrRemoval(time, random))
                    .toList();
            assertEquals(itemsInList(commands), TimelineModel.of(commands, DT).items());
        }
    }

    @Test
    void aRemovalOfAllFaultsEndsThoseOfItsSensorOnly() {
        List<TimedCommand> commands = List.of(
                inject(1, "left", STUCK), inject(2, "left", DEAD), inject(2, "rear", DEAD), clearAll(5, "left"));
        assertEquals(List.of("left 1.0 5.0", "left 2.0 5.0", "rear 2.0 Infinity"), spans(commands));
    }

    @Test
    void aRemovalOfAllFaultsLeavesThoseThatHaveEndedAndARemovalAfterItIsAMark() {
        List<TimedCommand> commands = List.of(
                inject(1, "left", STUCK),
                inject(2, "left", STUCK),
                clear(3, "left", STUCK),
                clearAll(5, "left"),
                clear(6, "left", STUCK),
                inject(7, "left", STUCK),
                clear(8, "left", STUCK));
        assertEquals(List.of("left 1.0 3.0", "left 2.0 5.0", "left 6.0 6.0", "left 7.0 8.0"), spans(commands));
    }

    @Test
    void aSensorThatIsSwitchedOffAndOnAgainIsOneItem() {
        List<TimedCommand> commands = List.of(turn(1, "left", true), turn(2, "left", false), turn(4, "left", true));
        assertEquals(List.of("left 1.0 1.0", "left 2.0 4.0"), spans(commands));
        assertTrue(TimelineModel.of(commands, DT).items().get(1).isInterval());
    }

    @Test
    void aSensorThatIsSwitchedOnIsOnHoweverOftenItWasSwitchedOff() {
        List<TimedCommand> commands = List.of(turn(1, "left", false), turn(2, "left", false), turn(3, "left", true));
        assertEquals(List.of("left 1.0 3.0", "left 2.0 3.0"), spans(commands));
    }

    @Test
    void aSensorThatIsOffForLongerIsNotSwitchedOnInTheMeantime() {
        TimelineModel model = TimelineModel.of(List.of(turn(1, "left", false), turn(5, "left", true)), DT);
        TimelineItem off = model.items().get(0);
        assertEquals(List.of("left 1.0 7.0", "left 3.0 7.0"), spans(model.with(off.withTimes(3, 7))));
        assertEquals(List.of("left 1.0 5.0", "left 3.0 5.0"), spans(model.with(off.withTimes(3, 5))));
        assertEquals(List.of("left 1.0 5.0", "left 5.0 9.0"), spans(model.with(off.withTimes(5, 9))));
        TimelineModel both = TimelineModel.of(model.with(off.withTimes(3, 7)), DT);
        assertEquals(List.of("left 3.0 7.0"), spans(both.without(0)));
        assertEquals(List.of("left 1.0 9.0", "left 3.0 9.0"), spans(both.with(0, off.withTimes(1, 9))));
    }

    @Test
    void aRemovalWithoutAFaultIsAMark() {
        assertEquals(List.of("left 3.0 3.0"), spans(List.of(clear(3, "left", DEAD))));
    }

    @Test
    void aChangedItemKeepsTheOrderOfAllOtherCommands() {
        List<TimedCommand> commands =
                List.of(move(1), inject(2, "left", STUCK), move(3), clear(4, "left", STUCK), move(5));
        TimelineModel model = TimelineModel.of(commands, DT);
        TimelineItem fault = model.items().get(1);
        assertEquals(
                List.of(move(1), inject(2.5, "left", STUCK), clear(6, "left", STUCK), move(3), move(5)),
                model.with(1, fault.withTimes(2.5, 6)));
        assertEquals(
                List.of(move(1), inject(2, "left", STUCK), move(3), move(5)),
                model.with(1, fault.withTimes(2, END_OF_RUN)));
        assertEquals(List.of(move(1), move(3), move(5)), model.without(1));
        assertEquals(commands, model.commands());
    }

    @Test
    void movingOneEndOfSeveralFaultsThatEndTogetherLeavesTheOthers() {
        List<TimedCommand> commands = List.of(inject(1, "left", STUCK), inject(2, "left", DEAD), clearAll(5, "left"));
        TimelineModel model = TimelineModel.of(commands, DT);
        List<TimedCommand> changed = model.with(0, model.items().get(0).withTimes(1, 7));
        assertEquals(List.of("left 1.0 7.0", "left 2.0 5.0"), spans(changed));
        assertEquals(List.of("left 2.0 5.0"), spans(model.without(0)));
    }

    @Test
    void aFaultThatIsExtendedAcrossTheRemovalOfAllFaultsIsNotEndedByIt() {
        List<TimedCommand> commands = List.of(
                inject(1, "left", STUCK), clear(3, "left", STUCK), inject(2, "left", DEAD), clearAll(5, "left"));
        TimelineModel model = TimelineModel.of(commands, DT);
        TimelineItem stuck = model.items().get(0);
        List<String> extended = List.of("left 1.0 7.0", "left 2.0 5.0");
        assertEquals(extended, spans(model.with(0, stuck.withTimes(1, 7))));
        assertEquals(List.of("left 1.0 5.0", "left 2.0 5.0"), spans(model.with(0, stuck.withTimes(1, 5))));
        assertEquals(List.of("left 1.0 3.0", "left 2.0 5.0", "left 4.0 6.0"), spans(model.with(stuck.withTimes(4, 6))));
        assertEquals(commands.get(3), model.with(stuck.withTimes(6, 8)).get(3), "a removal before the fault stays");
        List<TimedCommand> equal = List.of(inject(1, "left", DEAD), inject(2, "left", DEAD), clearAll(5, "left"));
        assertEquals(
                List.of("left 1.0 5.0", "left 2.0 5.0", "left 3.0 6.0"),
                spans(TimelineModel.of(equal, DT).with(stuck.withTimes(3, 6))));
    }

    @Test
    void anItemCanBeCopiedToAnotherSensorAndTime() {
        TimelineItem item = TimelineModel.of(List.of(inject(1, "left", STUCK), clear(3, "left", STUCK)), DT)
                .items()
                .get(0);
        TimelineItem copy = item.inLane(new Lane.SensorLane("rear")).withTimes(10, 12);
        List<TimedCommand> both = new ArrayList<>(item.commands());
        both.addAll(copy.commands());
        assertEquals(List.of("left 1.0 3.0", "rear 10.0 12.0"), spans(both));
        assertEquals(both, TimelineModel.of(item.commands(), DT).with(copy));
    }

    @Test
    void faultsOfMotorsHaveLanesOfTheirOwn() {
        MotorFault weak = new MotorFault.Weak(0.7);
        Command inject = new Command.InjectMotorFault(MotorSide.LEFT, weak);
        List<TimedCommand> commands =
                List.of(new TimedCommand(2, inject), new TimedCommand(4, new Command.ClearMotorFaults(MotorSide.LEFT)));
        assertEquals(List.of("left motors 2.0 4.0"), spans(commands));
        TimelineItem item = TimelineModel.of(commands, DT).items().get(0);
        assertEquals(
                "right motors",
                item.inLane(new Lane.MotorLane(MotorSide.RIGHT)).lane().label());
        assertEquals(item, item.inLane(new Lane.SensorLane("left")), "a fault of motors is none of a sensor");
    }

    /** A file has an end as {@code until} if it follows its fault, whichever fault it ends. */
    @Test
    void aSavedFileOfOverlappingEqualFaultsHasTheSameLanes(@TempDir Path folder) throws ScenarioException, IOException {
        Scenario office = Scenario.load(Path.of("scenarios/office.xml"));
        List<TimedCommand> nested = List.of(
                inject(20, "left", STUCK),
                clear(80, "left", STUCK),
                inject(30, "left", STUCK),
                clear(40, "left", STUCK));
        Scenario saved = office.withSetup(office.setup().withTimeline(nested));
        Path file = Files.write(folder.resolve("saved.xml"), saved.toBytes());
        Scenario read = Scenario.load(file);
        assertEquals(nested, read.setup().timeline());
        assertEquals(
                List.of("left 20.0 40.0", "left 30.0 80.0"), spans(read.setup().timeline()));
    }
}
