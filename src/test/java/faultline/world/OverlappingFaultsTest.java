package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.CpuTime;
import faultline.geometry.Pose;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultSequence;
import faultline.sensor.SignalFault;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Many faults of one sensor at the same time, as a scenario file may have them. */
class OverlappingFaultsTest {

    private static final int FRONT = 0;
    private static final int FAULTS = 60_000;

    private static World world() {
        return new World(new WorldSpec(4, 4, true, 1, List.of()), RobotSpec.DEFAULT, new Pose(3.5, 2, 0), 0.01, 1);
    }

    @Test
    void manyFaultsOfASensorNeedTimeInProportionToTheirNumber() {
        World world = world();
        CpuTime time = CpuTime.start();
        for (int i = 0; i < FAULTS; i++) {
            world.execute(new Command.InjectFault("front", new Fault.Stuck(i % 2 == 0 ? 0.4 : 0.3)));
            if (i % (FAULTS / 100) == 0) {
                world.move(0, 0);
                world.sense();
            }
        }
        for (int i = 0; i < FAULTS / 2; i++) {
            world.execute(new Command.ClearFault("front", world.faults(FRONT).get(0)));
        }
        assertEquals(FAULTS / 2, world.faults(FRONT).size());
        time.assertBelow(3);
    }

    @Test
    void manyFaultsOfAMotorNeedTimeInProportionToTheirNumber() {
        World world = world();
        CpuTime time = CpuTime.start();
        for (int i = 0; i < FAULTS; i++) {
            world.execute(new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.Weak(0.5)));
        }
        assertEquals(FAULTS, world.motorFaults().left().size());
        time.assertBelow(3);
    }

    @Test
    void theInverseRestoresTheFaultsThatThereWereBeforeLaterChanges() {
        World world = world();
        List<Fault> faults = List.of(new Fault.Bias(0.1), new Fault.Stuck(0.4), new Fault.Bias(0.1));
        List<CommandResult> results = new ArrayList<>();
        faults.forEach(fault -> results.add(world.execute(new Command.InjectFault("front", fault))));
        results.add(world.execute(new Command.ClearFault("front", faults.get(0))));
        results.add(world.execute(new Command.ClearFaults("front")));
        for (int i = 0; i <= faults.size(); i++) {
            List<Command> expected = new ArrayList<>(List.of(new Command.ClearFaults("front")));
            faults.subList(0, i).forEach(fault -> expected.add(new Command.InjectFault("front", fault)));
            assertEquals(expected, results.get(i).inverse());
        }
        results.get(4).inverse().forEach(world::execute);
        assertEquals(faults.subList(1, 3), world.faults(FRONT));
        List<Command> restoration = results.get(3).inverse();
        assertEquals(
                restoration,
                CommandResult.restoration(restoration.get(0), FaultSequence.copyOf(restoration.subList(1, 4))));
    }

    /** The true reading of the front sensor is 0.375 m. */
    private static void assertErrorAfter(double error, int ticks, World world) {
        for (int i = 0; i < ticks; i++) {
            world.move(0, 0);
            world.sense();
        }
        assertEquals(0.375 + error, world.reportedReading(FRONT), 1e-12);
    }

    @Test
    void theEndOfOneOfSeveralEqualFaultsEndsTheOldest() {
        for (Fault other : List.of(new SignalFault.Scale(1), new SignalFault.Drift(0.2))) {
            World world = world();
            Fault drift = new SignalFault.Drift(0.1);
            world.execute(new Command.InjectFault("front", drift));
            assertErrorAfter(0.01, 11, world);
            world.execute(new Command.InjectFault("front", other));
            world.execute(new Command.InjectFault("front", drift));
            double added = other.value() == 1 ? 0 : 0.02;
            assertErrorAfter(0.021 + 0.01 + added, 11, world);
            world.execute(new Command.ClearFault("front", drift));
            assertErrorAfter(0.011 + added * 1.1, 1, world);
            world.execute(new Command.ClearFault("front", drift));
            assertErrorAfter(added * 1.2, 1, world);
        }
    }

    @Test
    void equalFaultsContinueWhenAnotherIsAddedAndAnotherKindEnds() {
        World world = world();
        Fault drift = new SignalFault.Drift(0.1);
        world.execute(new Command.InjectFault("front", new Fault.Bias(0.1)));
        world.execute(new Command.InjectFault("front", drift));
        assertErrorAfter(0.11, 11, world);
        world.execute(new Command.ClearFault("front", new Fault.Bias(0.1)));
        world.execute(new Command.InjectFault("front", drift));
        assertErrorAfter(0.031, 11, world);
    }

    @Test
    void aFaultThatEndsAndBeginsAgainInTheSameTickContinues() {
        World world = world();
        Fault drift = new SignalFault.Drift(0.1);
        world.execute(new Command.InjectFault("front", drift));
        assertErrorAfter(0.01, 11, world);
        world.execute(new Command.ClearFault("front", drift));
        world.execute(new Command.InjectFault("front", drift));
        assertErrorAfter(0.02, 10, world);
    }

    /** Up to six drifts of two rates; three times a tick, one begins or ends. */
    @Test
    void theDriftsAreThoseOfListsWhoseFirstEntriesEnd() {
        Random random = new Random(2);
        World world = world();
        List<List<Integer>> starts = List.of(new ArrayList<>(), new ArrayList<>());
        int[] counts = new int[2];
        for (int tick = 0; tick < 2000; tick++) {
            for (int i = 0; i < 3; i++) {
                int rate = random.nextInt(2);
                Fault drift = new SignalFault.Drift(0.1 * (rate + 1));
                if (counts[0] + counts[1] < 6 && random.nextBoolean()) {
                    counts[rate]++;
                    world.execute(new Command.InjectFault("front", drift));
                } else if (counts[rate] > 0) {
                    counts[rate]--;
                    world.execute(new Command.ClearFault("front", drift));
                }
            }
            double error = 0;
            for (int rate = 0; rate < 2; rate++) {
                List<Integer> equal = starts.get(rate);
                while (equal.size() > counts[rate]) {
                    equal.remove(0);
                }
                while (equal.size() < counts[rate]) {
                    equal.add(tick);
                }
                for (int start : equal) {
                    error += 0.001 * (rate + 1) * (tick - start);
                }
            }
            assertErrorAfter(error, 1, world);
        }
    }
}
