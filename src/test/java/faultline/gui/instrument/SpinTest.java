package faultline.gui.instrument;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.Hand;
import faultline.control.Timing;
import faultline.engine.Frame;
import faultline.engine.Setup;
import faultline.engine.record.EventLog;
import faultline.engine.record.RunEvent;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The t_D/2 instrument: its numbers are the controller's and the run's own. */
class SpinTest {

    private static final Frame FRAME = Runs.frame(2000);

    /** The tick of the newest transition to a state. */
    private static long arrival(Frame frame, FollowerState state) {
        EventLog log = frame.recording().events();
        for (long i = log.end() - 1; i >= 0; i--) {
            if (log.get(i) instanceof RunEvent.Transition transition && transition.to().equals(state.name())) {
                return transition.tick();
            }
        }
        throw new AssertionError("the run never came to " + state);
    }

    @Test
    void beforeTheFirstTurnThereIsNone() {
        assertEquals(Optional.empty(), Spin.latest(Runs.frame(10)));
    }

    @Test
    void timesAreTheControllersAndTpIsHalfOfTd() {
        Spin spin = Spin.latest(FRAME).orElseThrow();
        assertEquals(FRAME.control().tF3(), spin.f3());
        assertEquals(FRAME.control().tF4(), spin.f4());
        assertEquals(spin.tD() / 2, spin.tP(), 1e-12);
    }

    @ParameterizedTest
    @EnumSource(Hand.class)
    void theAchievedHeadingIsThatOfTheHandOverAndCloseToThePredictedOne(Hand hand) {
        Setup setup = Runs.setup(new ControllerSpec.WallFollowing(0.25, hand, 0, Timing.EQUAL_READINGS));
        Frame frame = Runs.frame(setup, 2000);
        Spin spin = Spin.latest(frame).orElseThrow();
        double handOver = Runs.frame(setup, arrival(frame, FollowerState.ALIGN) + 1).world().pose().heading();
        assertTrue(Math.abs(handOver - spin.achieved().orElseThrow()) > 0.01, "the turn back is not over when ALIGN begins");
        double atFollow = Runs.frame(setup, arrival(frame, FollowerState.FOLLOW) - 1).world().pose().heading();
        assertEquals(atFollow, spin.achieved().orElseThrow(), 1e-5);
        assertEquals(0, Math.toDegrees(spin.error().orElseThrow()), 0.5);
        assertEquals(0, Math.toDegrees(Math.IEEEremainder(spin.achieved().orElseThrow(), Math.PI / 2)), 1.0, "along a wall of the room");
    }

    @Test
    void theReadingsFallToTheWallAndRiseAgainAroundTheMiddleOfTd() {
        Spin spin = Spin.latest(FRAME).orElseThrow();
        Spin.Sample nearest = spin.samples().stream().filter(sample -> sample.clock() >= spin.f3())
                .min((one, other) -> Double.compare(one.reading(), other.reading())).orElseThrow();
        assertEquals((spin.f3() + spin.f4()) / 2, nearest.clock(), spin.tD() / 4);
        double last = spin.samples().get(spin.samples().size() - 1).reading();
        assertTrue(last > nearest.reading() + 0.01, last + " after " + nearest.reading());
        assertEquals(spin.clock(spin.predicted()), (spin.f3() + spin.f4()) / 2, 1e-9);
    }

    @Test
    void inTheMiddleOfATurnWhatIsNotKnownYetIsADash() {
        long turn = arrival(FRAME, FollowerState.TURN);
        TimingInstrument instrument = onEdt(TimingInstrument::new);
        edt(() -> instrument.show(Runs.frame(turn + 5)));
        List<String> values = onEdt(() -> instrument.rows().stream().map(SpinText.Row::value).toList());
        assertEquals(List.of("–", "–", "–", "–", "–", "–", "–"), values);
        edt(() -> Runs.picture(instrument, 900, 200));
    }

    @Test
    void allNumbersAreSaidForReadersOfTheScreen() {
        TimingInstrument instrument = onEdt(TimingInstrument::new);
        edt(() -> instrument.show(FRAME));
        String words = onEdt(() -> instrument.getAccessibleContext().getAccessibleDescription());
        assertTrue(words.matches("F3 \\d\\.\\d{3} s, F4 \\d\\.\\d{3} s, t_D \\d\\.\\d{3} s, t_p \\d\\.\\d{3} s, predicted heading .+°, achieved heading .+°, error [+\u2212]0\\.\\d\\d°"),
                words);
        edt(() -> Runs.picture(instrument, 900, 200));
    }
}
