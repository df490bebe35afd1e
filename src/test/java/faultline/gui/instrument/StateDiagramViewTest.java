package faultline.gui.instrument;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.StateTracker;
import faultline.control.Telemetry;
import faultline.control.ladder.FaultTolerantFollower;
import faultline.control.wallfollower.StateDiagram;
import faultline.control.wallfollower.StateDiagram.Arrow;
import faultline.engine.ControllerFactory;
import faultline.engine.Frame;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.RunEvent;
import faultline.engine.recording.StateTally;
import faultline.engine.session.SampleSessionFrames;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Vector2;
import faultline.gui.text.StateText;
import faultline.gui.theme.Theme;
import faultline.paint.chart.StateDiagramLayout;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.ShortenedText;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** The state diagram without a display: the current state, the last transition, and their descriptions. */
class StateDiagramViewTest {

    private static final int WIDTH = 480;
    private static final int HEIGHT = 200;
    private static final StateDiagramLayout LAYOUT = new StateDiagramLayout(new PixelRectangle(0, 0, WIDTH, HEIGHT));
    private static final SessionFrame FRAME = SampleRuns.frame(2000);

    private final StateDiagramView view = callOnEdt(StateDiagramView::new);

    private BufferedImage picture(SessionFrame frame) {
        return callOnEdt(() -> {
            view.setFrame(frame);
            return SampleRuns.render(view, WIDTH, HEIGHT);
        });
    }

    private static Color ground(BufferedImage picture, FollowerState state) {
        Rectangle2D box = LAYOUT.box(state);
        return new Color(picture.getRGB((int) box.getX() + 6, (int) box.getY() + 6));
    }

    @Test
    void onlyTheStateThatHoldsIsFilled() {
        for (long tick : new long[] {0, 500, 800, 2000}) {
            SessionFrame frame = SampleRuns.frame(tick);
            BufferedImage picture = picture(frame);
            for (FollowerState state : FollowerState.values()) {
                boolean holds = state == frame.telemetry().state();
                assertEquals(
                        holds
                                ? Theme.currentColours().accent().getRGB()
                                : Theme.currentColours().field().getRGB(),
                        ground(picture, state).getRGB(),
                        state + " at tick " + tick);
            }
        }
    }

    @Test
    void boxesKeepApartAndInsideAtAnySize() {
        for (int width : new int[] {330, 480, 1200}) {
            StateDiagramLayout layout = new StateDiagramLayout(new PixelRectangle(0, 0, width, width / 2.2));
            for (FollowerState one : FollowerState.values()) {
                assertTrue(new Rectangle2D.Double(0, 0, width, width / 2.2).contains(layout.box(one)));
                for (FollowerState other : FollowerState.values()) {
                    assertEquals(one == other, layout.box(one).intersects(layout.box(other)), one + " and " + other);
                }
            }
        }
    }

    @Test
    void everyArrowEndsAtTheEdgeOfItsState() {
        for (Arrow arrow : StateDiagram.TRANSITIONS) {
            Vector2 tip = LAYOUT.route(arrow).tip();
            Rectangle2D box = LAYOUT.box(arrow.to());
            double across = Math.min(Math.abs(tip.x() - box.getX()), Math.abs(tip.x() - box.getMaxX()));
            double down = Math.min(Math.abs(tip.y() - box.getY()), Math.abs(tip.y() - box.getMaxY()));
            assertEquals(0, Math.min(across, down), 1e-9, arrow.toString());
            assertTrue(box.intersects(tip.x() - 1, tip.y() - 1, 2, 2), arrow.toString());
        }
    }

    @Test
    void noArrowBetweenAnyTwoStatesCrossesABoxOrItsNumber() {
        for (PixelRectangle area : List.of(
                new PixelRectangle(0, 0, 330, 150),
                new PixelRectangle(0, 0, WIDTH, 105),
                new PixelRectangle(0, 0, WIDTH, HEIGHT))) {
            StateDiagramLayout layout = new StateDiagramLayout(area);
            for (FollowerState from : FollowerState.values()) {
                for (FollowerState to : FollowerState.values()) {
                    if (from != to) {
                        assertNothingIsCrossed(layout, new Arrow(from, to, ""));
                    }
                }
            }
        }
    }

    private static void assertNothingIsCrossed(StateDiagramLayout layout, Arrow arrow) {
        StateDiagramLayout.ArrowRoute route = layout.route(arrow);
        Shape line = new BasicStroke(1).createStrokedShape(route.shaft());
        for (FollowerState state : FollowerState.values()) {
            Rectangle2D box = layout.box(state);
            Rectangle2D inside =
                    new Rectangle2D.Double(box.getX() + 1, box.getY() + 1, box.getWidth() - 2, box.getHeight() - 2);
            assertFalse(line.intersects(inside), arrow + " crosses " + state);
        }
        Vector2 number = route.numberCentre(21, 8);
        assertFalse(line.intersects(number.x() - 10.5, number.y() - 4, 21, 8), arrow + " crosses its number");
    }

    @Test
    void aTransitionOfAnotherStrategyHasAnArrow() {
        StateTally tally = new StateTally(
                List.of(),
                List.of(
                        new StateTally.TransitionCount(FollowerState.SEARCH, FollowerState.TURN, 1),
                        new StateTally.TransitionCount(FollowerState.FOLLOW, FollowerState.MEASURE, 12),
                        new StateTally.TransitionCount(FollowerState.FOLLOW, FaultTolerantFollower.STOP, 1)));
        List<Arrow> arrows = DiagramPainter.arrows(tally);
        assertEquals(StateDiagram.TRANSITIONS.size() + 1, arrows.size());
        assertEquals(new Arrow(FollowerState.FOLLOW, FollowerState.MEASURE, ""), arrows.get(arrows.size() - 1));
    }

    @Test
    void whatWasTakenLastAndAllArrowsAreSaidForReadersOfTheScreen() {
        picture(FRAME);
        String description = callOnEdt(() -> view.getAccessibleContext().getAccessibleDescription());
        String first =
                "State Follow. Align → Follow: turned back for t_p, spin died out. Search → Turn: wall met (1×); ";
        assertTrue(description.startsWith(first), description);
        for (Arrow arrow : StateDiagram.TRANSITIONS) {
            String text = StateText.transition(arrow.from(), arrow.to(), arrow.condition()) + " (";
            assertTrue(description.contains(text), text + " in " + description);
        }
    }

    @Test
    void inALowWindowEveryBoxHasRoomForItsName() {
        StateDiagramLayout low = new StateDiagramLayout(new PixelRectangle(0, 0, WIDTH, 105));
        for (FollowerState state : FollowerState.values()) {
            assertTrue(low.box(state).getHeight() >= 20, state + " " + low.box(state));
        }
        double gap = low.box(FollowerState.FOLLOW).getMinY()
                - low.box(FollowerState.TURN).getMaxY();
        assertTrue(gap >= 8, "gap " + gap);
    }

    /** The room that a window of 640 by 480 leaves beside the control panel. */
    @Test
    void inANarrowWindowTheNamesStayInTheirBoxes() {
        StateDiagramLayout narrow = new StateDiagramLayout(new PixelRectangle(0, 0, 155, 90));
        FontMetrics smallest = view.getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, 8));
        for (FollowerState state : FollowerState.values()) {
            double room = narrow.box(state).getWidth();
            assertTrue(room >= 40, state + " has " + room);
            String name = ShortenedText.of(StateText.name(state), smallest, room);
            assertEquals(StateText.name(state), name);
            String part = ShortenedText.of("a name that is far too long", smallest, room);
            assertTrue(part.startsWith("a n") && part.endsWith("...") && smallest.stringWidth(part) <= room, part);
        }
    }

    @Test
    void aNameIsMadeSmallerBeforeItIsShortened() {
        Font bold = new Font(Font.SANS_SERIF, Font.BOLD, 13);
        String name = "Pomiar";
        int smallest = view.getFontMetrics(bold.deriveFont(8f)).stringWidth(name);
        for (int room = smallest; room < 60; room++) {
            Font fitted = DiagramPainter.fitted(name, bold, room, view::getFontMetrics);
            assertTrue(view.getFontMetrics(fitted).stringWidth(name) <= room, room + " pixels in " + fitted);
        }
    }

    @Test
    void theNameOfTheActiveStateIsBoldOnlyIfItFits() {
        Font plain = new Font(Font.SANS_SERIF, Font.PLAIN, 13);
        String name = "Wyrównanie";
        double room = view.getFontMetrics(plain.deriveFont(8f)).stringWidth(name);
        assertFalse(DiagramPainter.boldIfFitting(name, plain, room, view::getFontMetrics)
                .isBold());
        assertTrue(DiagramPainter.boldIfFitting(name, plain, 2 * room, view::getFontMetrics)
                .isBold());
    }

    @Test
    void anArrowUnderTheMouseExplainsItself() {
        picture(FRAME);
        assertEquals("Search → Turn: wall met (1×)", toolTipOfTheFirstArrow());
    }

    @Test
    void anArrowOfAnotherControllerHasNoConditionOfTheFollower() {
        ControllerSpec own = new ControllerSpec.Provided("mine", 0, Map.of());
        picture(new SessionFrame(FRAME.frame(), FRAME.recording(), FRAME.measures(), own, "mine", FRAME.dt()));
        assertEquals("Search → Turn (1×)", toolTipOfTheFirstArrow());
    }

    private String toolTipOfTheFirstArrow() {
        Vector2 middle = LAYOUT.route(StateDiagram.TRANSITIONS.get(0)).tip();
        return callOnEdt(() -> view.getToolTipText(
                new MouseEvent(view, MouseEvent.MOUSE_MOVED, 0, 0, (int) middle.x() - 12, (int) middle.y(), 0, false)));
    }

    @Test
    void withoutADiagramNoArrowExplainsItself() {
        assertNoArrowExplainsItself();
        picture(SampleRuns.frame(SampleRuns.setup(new ControllerSpec.None()), 10));
        assertNoArrowExplainsItself();
    }

    private void assertNoArrowExplainsItself() {
        runOnEdt(() -> view.setSize(WIDTH, HEIGHT));
        for (Arrow arrow : StateDiagram.TRANSITIONS) {
            Vector2 tip = LAYOUT.route(arrow).tip();
            assertNull(callOnEdt(() -> view.getToolTipText(
                    new MouseEvent(view, MouseEvent.MOUSE_MOVED, 0, 0, (int) tip.x(), (int) tip.y(), 0, false))));
        }
    }

    @Test
    void theTextsAreTheControllersOwn() {
        for (Arrow arrow : StateDiagram.TRANSITIONS) {
            // F3 and F4 are the moments that the timing rule finds, not those of the transitions, and the wall of a
            // scenario may be on the right.
            String own = arrow.condition().replaceAll(" \\(F\\d\\)", "").replace("left sensor", "side sensor");
            assertEquals(own, StateText.condition(arrow.from(), arrow.to(), arrow.condition()));
        }
        for (FollowerState state : FollowerState.values()) {
            assertFalse(StateText.name(state).equals(state.name()), state + " has no name for people");
        }
    }

    @Test
    void anotherControllerHasNoDiagram() {
        BufferedImage picture = picture(SampleRuns.frame(SampleRuns.setup(new ControllerSpec.None()), 10));
        assertEquals(0, SampleRuns.count(picture, Theme.currentColours().accent()));
        assertEquals("State None", callOnEdt(() -> view.getAccessibleContext().getAccessibleDescription()));
    }

    @Test
    void aControllerFromOutsideHasASentence() {
        ControllerSpec chosen = new ControllerSpec.Provided("right-turner", 0, Map.of());
        ControllerState unnamed = ControllerState.of("EXTERN");
        assertEquals("The controller has not made a decision yet.", sentence(0, unnamed, chosen, ""));
        assertEquals("The controller \"circle\" has not made a decision yet.", sentence(0, unnamed, chosen, "circle"));
        assertEquals("The controller has no state diagram.", sentence(500, unnamed, chosen, ""));
        assertEquals(
                "The controller \"circle\" has no state diagram.",
                sentence(500, ControllerState.of("circle"), chosen, "circle"));
        assertEquals(
                "The controller \"circle\" has no state diagram. It is in the state \"NEAR\".",
                sentence(500, ControllerState.of("NEAR"), chosen, "circle"));
        assertEquals(
                "This scenario needs a controller from outside. Choose one with Simulation > Choose controller.",
                sentence(0, unnamed, new ControllerSpec.Extern(0), ""));
    }

    @Test
    void aBuiltInControllerWithoutADiagramHasTheNameOfThePanel() {
        ControllerSpec drive = new ControllerSpec.Drive(1, 2);
        assertEquals(
                "The controller \"Constant voltages\" has no state diagram.",
                sentence(500, ControllerFactory.initialState(drive), drive, ""));
        ControllerSpec none = new ControllerSpec.None();
        assertEquals(
                "The controller \"None\" has no state diagram.",
                sentence(500, ControllerFactory.initialState(none), none, ""));
    }

    private static String sentence(long tick, ControllerState state, ControllerSpec spec, String name) {
        SessionFrame of = SampleRuns.frame(tick);
        Frame frame = frame(of.frame(), state, "");
        return StateDiagramView.otherText(new SessionFrame(frame, of.recording(), of.measures(), spec, name, of.dt()));
    }

    @Test
    void aSentenceInLargeTextTakesMoreLines() {
        runOnEdt(() -> view.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 34)));
        BufferedImage picture = picture(SampleRuns.frame(SampleRuns.setup(new ControllerSpec.None()), 10));
        int ground = picture.getRGB(WIDTH - 1, HEIGHT - 1);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = WIDTH - 10; x < WIDTH; x++) {
                assertEquals(ground, picture.getRGB(x, y), x + ", " + y);
            }
        }
        assertTrue(SampleRuns.count(picture, Theme.currentColours().muted()) > 200, "nothing is written");
    }

    @Test
    void framesAreShownOnTheEventDispatchThreadOnly() {
        assertThrows(AssertionError.class, () -> view.setFrame(FRAME));
        runOnEdt(() -> view.setFrame(FRAME));
    }

    @Test
    void theStrategyIsNamedUnlessAllSensorsAreTrusted() {
        assertEquals("", strategy("ALL"));
        assertEquals("", strategy(""), "a controller without a diagnosis");
        assertEquals("4 of 6: two sensors, map · ", strategy("TWO"));
    }

    @Test
    void aStoppedFollowerKeepsItsDiagramWithoutACurrentState() {
        BufferedImage picture = picture(frame(FaultTolerantFollower.STOP, "STOP"));
        for (FollowerState state : FollowerState.values()) {
            assertEquals(Theme.currentColours().field(), ground(picture, state), state.toString());
        }
    }

    @Test
    void aCaptionWithoutRoomEndsInTheConditionOrElseInTheWholeTransition() {
        SessionFrame frame = frame(FollowerState.FOLLOW, "THREE");
        RunEvent.StateChanged other =
                new RunEvent.StateChanged(9, 0.09, FollowerState.MEASURE, FollowerState.FOLLOW, "");
        RunEvent.StateChanged own =
                new RunEvent.StateChanged(9, 0.09, FollowerState.SEARCH, FollowerState.TURN, "wall met");
        assertEquals("3 of 6: three sensors, map · Measure → Follow", caption(frame, other, 1000));
        assertEquals("3 of 6: three sensors, map · Measure → Follow", caption(frame, other, 200));
        String condition = "wall met";
        assertEquals("3 of 6: three sensors, map · Search → Turn: " + condition, caption(frame, own, 1000));
        assertEquals("3 of 6: three sensors, map · " + condition, caption(frame, own, 200));
    }

    private static String caption(SessionFrame frame, RunEvent.StateChanged last, double width) {
        Graphics2D graphics = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        try {
            return DiagramPainter.caption(
                    frame, last, width, graphics.getFontMetrics(new Font(Font.SANS_SERIF, Font.BOLD, 11)));
        } finally {
            graphics.dispose();
        }
    }

    @Test
    void theFirstStateOfAControllerFromOutsideIsNoTransition() {
        List<FollowerState> states = List.of(FollowerState.SEARCH, FollowerState.SEARCH, FollowerState.TURN);
        SimulationSetup setup =
                SampleRuns.setup(new ControllerSpec.Chosen(new ControllerSpec.Extern(0), states(states)));
        SessionFrame first = SampleRuns.frame(setup, 2);
        assertEquals(FollowerState.SEARCH, first.telemetry().state());
        assertEquals(Optional.empty(), DiagramPainter.lastTransition(first));
        assertEquals("No transition yet", caption(first, null, 1000));
        RunEvent.StateChanged second =
                DiagramPainter.lastTransition(SampleRuns.frame(setup, 3)).orElseThrow();
        assertEquals(FollowerState.TURN, second.to());
    }

    private static ControllerSource states(List<FollowerState> states) {
        return new ControllerSource() {
            @Override
            public Controller start(RunConditions run) {
                Controller named =
                        observation -> new Decision(1, 1, Telemetry.ofState(states.get((int) observation.tick())));
                return new StateTracker(named, "");
            }

            @Override
            public boolean limitsAnswerTime() {
                return true;
            }
        };
    }

    private static String strategy(String rung) {
        return DiagramPainter.strategyText(frame(FRAME.telemetry().state(), rung));
    }

    private static SessionFrame frame(ControllerState state, String rung) {
        return SampleSessionFrames.unmeasured(frame(FRAME.frame(), state, rung), FRAME.recording());
    }

    private static Frame frame(Frame old, ControllerState state, String rung) {
        Telemetry telemetry = old.telemetry();
        return new Frame(
                old.snapshot(),
                new Telemetry(
                        state,
                        telemetry.condition(),
                        telemetry.sinceTick(),
                        telemetry.transitions(),
                        telemetry.wall(),
                        telemetry.edges(),
                        new Telemetry.Diagnosis(rung, List.of())),
                old.leftVolts(),
                old.rightVolts(),
                old.path(),
                old.trajectoryHash());
    }
}
