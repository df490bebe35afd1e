package faultline.gui.window;

import static faultline.engine.session.SampleSessionFrames.unmeasured;
import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.SampleFrames;
import faultline.engine.metrics.RunMeasures;
import faultline.engine.recording.Recording;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.gui.ComponentFinder;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.ComparisonActions;
import faultline.gui.action.EditActions;
import faultline.gui.action.Notes;
import faultline.gui.action.ObstacleActions;
import faultline.gui.action.PreferenceActions;
import faultline.gui.action.RunActions;
import faultline.gui.action.SensorActions;
import faultline.gui.action.SpeedScale;
import faultline.gui.action.UiAction;
import faultline.gui.action.ViewActions;
import faultline.gui.bar.StatusBar;
import faultline.gui.bar.ToolBar;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.canvas.tool.MenuTarget;
import faultline.gui.dialog.Dialogs;
import faultline.gui.dialog.FileController;
import faultline.gui.document.ComparisonController;
import faultline.gui.document.RunController;
import faultline.gui.document.TaskKind;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ObstacleEditor;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.SensorEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.export.ExportController;
import faultline.gui.panel.ControlPanel;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.TimelineEditor;
import faultline.paint.scene.Pixels;
import faultline.robot.MotorFaults;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.Box;
import javax.swing.CellRendererPane;
import javax.swing.DefaultBoundedRangeModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JPopupMenu;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.JToolBar;
import javax.swing.JViewport;
import javax.swing.MenuElement;
import javax.swing.SwingUtilities;
import javax.swing.table.JTableHeader;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The contents of the window without a display. */
class MainPanelTest {

    private static final Notes NO_NOTES = new Notes(text -> {}, text -> {}, text -> {}, text -> {});

    /** The actions in menus that the window itself provides. */
    private static final List<String> OTHER_ACTIONS = List.of(
            "nextArea",
            "previousArea",
            "previousEvent",
            "nextEvent",
            "lanesZoomIn",
            "lanesZoomOut",
            "lanesWhole",
            "new",
            "properties",
            "chooseController",
            "scenarioController",
            "batch",
            "openBatchResults",
            "compareController",
            "examples",
            "preferences",
            "tour");

    /** The number of frames that the canvas may take to paint everything on a slow machine. */
    private static final int MAX_FRAMES = 20;

    private static final SessionStatus PAUSED = new SessionStatus(false, 1, 0, 0, null, null);
    private static final SessionStatus FAST = new SessionStatus(true, 100, 12345.67, 0, null, null);

    private static final int MIN_SLIDER_WIDTH = 60;

    private ActionRegistry actions = new ActionRegistry();
    private SimulationCanvas canvas;
    private MainPanel mainPanel;
    private SensorActions sensors;
    private RobotMenu robotMenu;
    private JMenuBar menus;

    @BeforeEach
    void build() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            DefaultBoundedRangeModel speed =
                    new DefaultBoundedRangeModel(SpeedScale.REAL_TIME_POSITION, 0, 0, SpeedScale.UNLIMITED);
            Workspace workspace = new Workspace();
            workspace.addListener(new NoOpWorkspaceListener());
            RunController run = new RunController(workspace);
            CommandSender sender = new CommandSender(run::send);
            UndoController undo = new UndoController(sender, () -> {});
            canvas = new SimulationCanvas(sender);
            FileController files = new FileController(canvas, workspace, () -> false);
            files.addTo(actions, () -> {});
            new EditActions(undo, () -> false).addTo(actions);
            addSensorActions(workspace, new ScenarioEditor(run, undo), sender);
            new ExportController(canvas, workspace, canvas, files::chooseExportFile, file -> {}, NO_NOTES)
                    .actions()
                    .forEach(actions::add);
            ViewActions.addTo(actions, canvas);
            ViewActions.addPathColours(actions, canvas, WindowPreferences.nonPersistent());
            actions.add(UiAction.toggle("dark", false, on -> {}));
            new RunActions(run, speed, now -> OptionalDouble.empty()).addTo(actions);
            new Dialogs(null).addTo(actions);
            Stream.of("instruments", "timeline", "controlPanel")
                    .forEach(key -> actions.add(UiAction.toggle(key, true, shown -> {})));
            OTHER_ACTIONS.forEach(key -> actions.add(UiAction.of(key, () -> {})));
            new PreferenceActions(WindowPreferences.nonPersistent(), actions, () -> {});
            mainPanel = createMainPanel(workspace, run, sender, undo, speed);
            new ComparisonActions(
                            new ComparisonController(workspace, run.navigator()), mainPanel::setReferenceRun, NO_NOTES)
                    .addTo(actions, Optional::empty);
            menus = Menus.createMenuBar(actions);
            mainPanel.setFrame(unmeasured(SampleFrames.fullFrame(), Recording.EMPTY), PAUSED, List.of());
        });
    }

    private void addSensorActions(Workspace workspace, ScenarioEditor scenario, CommandSender sender) {
        SensorEditor editor = new SensorEditor(workspace, scenario, note -> {});
        sensors = new SensorActions(workspace, sender, editor, canvas.tools());
        sensors.addTo(actions);
        obstacleActions(sender).addTo(actions);
        robotMenu = new RobotMenu(sender, sensors, id -> {}, side -> {});
    }

    private ObstacleActions obstacleActions(CommandSender sender) {
        return new ObstacleActions(
                canvas.tools(),
                sender,
                sensors,
                NO_NOTES,
                now -> OptionalDouble.empty(),
                WindowPreferences.nonPersistent());
    }

    private MainPanel createMainPanel(
            Workspace workspace,
            RunController run,
            CommandSender sender,
            UndoController undo,
            DefaultBoundedRangeModel speed) {
        ScenarioEditor scenario = new ScenarioEditor(run, undo);
        TimelineEditor timeline = new TimelineEditor(workspace, run, undo, note -> {});
        return new MainPanel(
                canvas,
                new StatusBar(),
                new MainPanel.Editors(sender, scenario, sensors, new ObstacleEditor(workspace, scenario), timeline),
                actions,
                speed,
                tick -> {});
    }

    private static Stream<Arguments> windowSizes() {
        return Stream.of(new Dimension(1360, 800), new Dimension(1024, 550))
                .flatMap(room -> Stream.of(TextSize.values()).flatMap(size -> Stream.of(Language.values())
                        .map(language -> Arguments.of(room.width, room.height, size, language))));
    }

    @Test
    void exactlyOneButtonOfThePaletteIsOn() {
        runOnEdt(() -> {
            assertEquals(List.of("select"), paletteButtonsOn());
            for (String key : List.of("placeCircle", "drawWall", "select", "select", "placeEllipse")) {
                actions.get(key).actionPerformed(null);
                assertEquals(List.of(key), paletteButtonsOn());
            }
            actions.get("measure").actionPerformed(null);
            assertEquals(List.of(), paletteButtonsOn());
        });
    }

    private List<String> paletteButtonsOn() {
        return ObstacleActions.PALETTE_KEYS.stream()
                .filter(key -> actions.get(key).isOn())
                .toList();
    }

    @ParameterizedTest
    @MethodSource("windowSizes")
    void noComponentIsCutOffInAnyLanguageAndTextSize(int width, int height, TextSize size, Language language) {
        try {
            build(size, language);
            runOnEdt(() -> mainPanel.statusBar().showNote("A sentence that says why something has been refused."));
            runOnEdt(() -> setSizeAndLayOut(width, height));
            assertEquals(List.of(), callOnEdt(() -> ComponentFinder.tree(mainPanel)
                    .filter(MainPanelTest::mustBeWhole)
                    .filter(part -> !fits(part))
                    .map(MainPanelTest::describe)
                    .toList()));
            assertEquals(1, mainPanel.instruments().getTabRunCount(), "rows of tabs");
        } finally {
            build(TextSize.NORMAL, Language.ENGLISH);
        }
    }

    @ParameterizedTest
    @CsvSource({"ENGLISH, false", "POLISH, false", "ENGLISH, true", "POLISH, true"})
    void onASmallScreenWithLargeTextEveryTabOfTheControlPanelWrapsInsteadOfScrollingSideways(
            Language language, boolean instruments) throws ScenarioException {
        try {
            build(TextSize.LARGEST, language);
            // The instruments are hidden by default on a screen of this height.
            runOnEdt(() -> mainPanel.dividers().setDockShown(instruments));
            Scenario office = Scenario.load(Path.of("scenarios/office.xml"));
            runOnEdt(() -> mainPanel.controlPanel().setChosenController("python3 examples/follower.py --distance 0.3"));
            for (ControllerSpec controller : List.of(
                    ControllerSpec.WallFollowing.DEFAULT,
                    new ControllerSpec.Drive(1, 1),
                    new ControllerSpec.Extern(0))) {
                SessionFrame frame = new SessionFrame(
                        SampleFrames.fullFrame(), Recording.EMPTY, RunMeasures.NONE, controller, "", 0.01);
                runOnEdt(() -> mainPanel.setRun(frame, PAUSED, office, 100));
                assertEveryTabFits();
            }
            assertTrue(!instruments || mainPanel.instruments().getTabRunCount() == 1, "rows of tabs");
        } finally {
            build(TextSize.NORMAL, Language.ENGLISH);
        }
    }

    /** Asserts that no tab of the control panel scrolls sideways or cuts a control off in a window of 784 pixels. */
    private void assertEveryTabFits() {
        ControlPanel panel = mainPanel.controlPanel();
        JTabbedPane tabs = callOnEdt(() ->
                ComponentFinder.findAll(panel, JTabbedPane.class).findFirst().orElseThrow());
        for (int tab = 0; tab < tabs.getTabCount(); tab++) {
            int index = tab;
            runOnEdt(() -> {
                tabs.setSelectedIndex(index);
                setSizeAndLayOut(784, 560);
                JScrollPane scroll = (JScrollPane) tabs.getComponentAt(index);
                assertFalse(scroll.getHorizontalScrollBar().isVisible(), tabs.getTitleAt(index));
                assertEquals(
                        List.of(),
                        ComponentFinder.findAll(scroll.getViewport(), JComboBox.class)
                                .filter(MainPanelTest::isVisibleInTab)
                                .filter(box -> box.getWidth() < box.getPreferredSize().width)
                                .map(MainPanelTest::describe)
                                .toList());
                assertEquals(
                        List.of(),
                        ComponentFinder.tree(scroll.getViewport())
                                .filter(MainPanelTest::mustBeWhole)
                                .filter(part -> !fits(part))
                                .map(MainPanelTest::describe)
                                .toList());
            });
        }
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void withLargeTextTheTabsOfTheControlPanelAreInOneRowIn1024Pixels(Language language) {
        try {
            build(TextSize.LARGEST, language);
            JTabbedPane tabs = callOnEdt(() -> {
                setSizeAndLayOut(1022, 640);
                return ComponentFinder.findAll(mainPanel.controlPanel(), JTabbedPane.class)
                        .findFirst()
                        .orElseThrow();
            });
            assertEquals(4, callOnEdt(tabs::getTabCount));
            assertEquals(1, callOnEdt(tabs::getTabRunCount));
        } finally {
            build(TextSize.NORMAL, Language.ENGLISH);
        }
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void theSpeedStaysBesideItsNameAndItsValueInABarOfSeveralRows(Language language) {
        try {
            build(TextSize.LARGEST, language);
            for (int width = 500; width < 1100; width += 20) {
                int room = width;
                runOnEdt(() -> setSizeAndLayOut(room, 560));
                Rectangle slider = placeOf(JSlider.class);
                Rectangle name = placeOf(JLabel.class);
                assertEquals(slider.getCenterY(), name.getCenterY(), 2, width + ": " + slider + ", " + name);
                assertTrue(name.getMaxX() <= slider.getX(), width + ": " + slider + ", " + name);
            }
        } finally {
            build(TextSize.NORMAL, Language.ENGLISH);
        }
    }

    /** Returns the place in the contents of the window of the first part of the tool bar of a type. */
    private Rectangle placeOf(Class<? extends Component> type) {
        return callOnEdt(() -> ComponentFinder.findAll(mainPanel, ToolBar.class)
                .flatMap(bar -> ComponentFinder.findAll(bar, type))
                .findFirst()
                .map(part -> SwingUtilities.convertRectangle(part.getParent(), part.getBounds(), mainPanel))
                .orElseThrow());
    }

    private void build(TextSize size, Language language) {
        runOnEdt(size::install);
        Messages.setLanguage(language);
        actions = new ActionRegistry();
        build();
    }

    @Test
    void neitherNotesNorSelectionsAreKeptForAnotherScenario() {
        runOnEdt(() -> {
            JLabel note = ComponentFinder.find(mainPanel, JLabel.class, "Note");
            mainPanel.statusBar().showNote("Saved as a.xml");
            canvas.tools().selectSensor("rear");
            canvas.tools().selectAll();
            assertEquals("rear", chosenSensor());
            assertFalse(canvas.tools().selected().isEmpty());
            mainPanel.startScenario();
            mainPanel.setFrame(unmeasured(SampleFrames.fullFrame(), Recording.EMPTY), PAUSED, List.of());
            assertEquals("", note.getText());
            assertFalse(mainPanel.statusBar().isNoteShown());
            assertEquals("front", chosenSensor());
            assertTrue(canvas.tools().selected().isEmpty());
        });
    }

    private Object chosenSensor() {
        return ComponentFinder.find(mainPanel.controlPanel().sensorDetails(), JComboBox.class, "Sensor")
                .getSelectedItem();
    }

    @Test
    void aCollisionIsReportedOnTheCanvasOnlyWhileNoBannerReportsIt() throws ScenarioException {
        Scenario office = Scenario.load(Path.of("scenarios/office.xml"));
        SessionFrame collided = unmeasured(SampleFrames.fullFrame(), Recording.EMPTY);
        runOnEdt(() -> {
            setSizeAndLayOut(1360, 840);
            mainPanel.setRun(collided, FAST, office, 100);
            ComponentFinder.find(canvas, JButton.class, "Close this message").doClick();
        });
        BufferedImage before = callOnEdt(this::picture);
        runOnEdt(() -> mainPanel.setRun(collided, FAST, office, 100));
        assertTrue(Pixels.countDifferent(before, callOnEdt(this::picture)) > 1000, "no report after the banner");
    }

    /** As after a change of the length of the ticks whose restart was cancelled. */
    @Test
    void aRunIsShownWithItsOwnTicks() throws ScenarioException {
        Scenario office = Scenario.load(Path.of("scenarios/office.xml"));
        Scenario changed = office.withSetup(office.setup().withTick(0.05));
        SessionFrame frame = unmeasured(SampleFrames.fullFrame(), Recording.EMPTY);
        runOnEdt(() -> {
            mainPanel.setRun(frame, FAST, changed, 0);
            JSlider slider = ComponentFinder.findAll(mainPanel.timeline().bar(), JSlider.class)
                    .findFirst()
                    .orElseThrow();
            assertEquals(office.setup().ticks(), slider.getMaximum());
        });
    }

    @Test
    void noComponentMovesWhenNumbersChange() {
        runOnEdt(() -> setSizeAndLayOut(1360, 840));
        Map<Component, Rectangle> before = callOnEdt(this::places);
        SessionFrame frame = unmeasured(SampleFrames.fullFrame(), Recording.EMPTY);
        runOnEdt(() -> {
            mainPanel.setFrame(frame, FAST, List.of());
            setSizeAndLayOut(1360, 840);
        });
        assertEquals(before, callOnEdt(this::places));
    }

    @Test
    void everyControlHasAnAccessibleName() {
        List<String> nameless = callOnEdt(() -> ComponentFinder.tree(mainPanel)
                .filter(MainPanelTest::isUsed)
                .filter(part -> ComponentFinder.accessibleName(part).isBlank())
                .map(MainPanelTest::describe)
                .toList());
        assertEquals(List.of(), nameless);
        assertTrue(callOnEdt(() -> ComponentFinder.tree(mainPanel)
                        .filter(MainPanelTest::isUsed)
                        .count())
                > 40);
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void everyMenuItemHasAUniqueMnemonic(Language language) {
        Messages.setLanguage(language);
        actions = new ActionRegistry();
        build();
        assertMenuItemsHaveUniqueMnemonics();
        runOnEdt(() -> actions.get("run").rename("pause"));
        Messages.setLanguage(Language.ENGLISH);
        assertMenuItemsHaveUniqueMnemonics();
    }

    private void assertMenuItemsHaveUniqueMnemonics() {
        List<JMenu> all =
                callOnEdt(() -> ComponentFinder.findAll(menus, JMenu.class).toList());
        assertTrue(all.size() > 5);
        assertDistinct(all.stream()
                .filter(menu -> menu.getParent() == menus)
                .map(menu -> (AbstractButton) menu)
                .toList());
        all.forEach(menu -> assertDistinct(ComponentFinder.findAll(menu, AbstractButton.class)
                .filter(item -> item != menu)
                .filter(item -> !(item.getParent() instanceof MenuElement popup) || popup == menu.getPopupMenu())
                .toList()));
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void everyItemOfAContextMenuHasAUniqueMnemonic(Language language) {
        Messages.setLanguage(language);
        actions = new ActionRegistry();
        build();
        List<JPopupMenu> menusOfCanvas = callOnEdt(
                () -> Stream.of(MenuTarget.values()).map(this::contextMenu).toList());
        Messages.setLanguage(Language.ENGLISH);
        menusOfCanvas.forEach(menu -> assertDistinct(
                Stream.of(menu.getSubElements()).map(AbstractButton.class::cast).toList()));
    }

    private JPopupMenu contextMenu(MenuTarget target) {
        JPopupMenu menu = new JPopupMenu();
        if (target == MenuTarget.SENSOR) {
            robotMenu.addSensor(
                    menu, SampleFrames.fullFrame().snapshot().sensors().get(0));
        } else if (target == MenuTarget.ROBOT) {
            robotMenu.addNewSensor(menu, 0);
            robotMenu.addMotors(menu, MotorFaults.NONE);
        }
        Menus.addCanvasItems(menu, actions, target);
        return menu;
    }

    @Test
    void noTwoActionsHaveTheSameKey() {
        List<String> strokes = actions.allActions().stream()
                .flatMap(action -> action.accelerator().stream())
                .map(Object::toString)
                .toList();
        assertEquals(strokes.stream().distinct().toList(), strokes);
        assertTrue(strokes.size() > 20);
    }

    @Test
    void theArrowOfAComboBoxIsNotFocusable() {
        List<AbstractButton> arrows = callOnEdt(() -> ComponentFinder.findAll(mainPanel, AbstractButton.class)
                .filter(button -> button.getParent() instanceof JComboBox)
                .toList());
        assertTrue(arrows.size() >= 3);
        assertTrue(arrows.stream().noneMatch(AbstractButton::isFocusable));
    }

    @Test
    void theToolTipOfAnActionNamesItsKey() {
        assertEquals(
                "Advance by one tick (.)", callOnEdt(() -> ComponentFinder.find(mainPanel, AbstractButton.class, "Step")
                        .getToolTipText()));
    }

    @Test
    void theWindowIsPaintedInBothThemes() {
        for (Theme theme : Theme.values()) {
            runOnEdt(theme::install);
            build(theme);
            BufferedImage image = callOnEdt(this::picture);
            long ground = IntStream.range(55, 95)
                    .filter(x ->
                            image.getRGB(x, 400) == theme.palette().canvas().getRGB())
                    .count();
            assertTrue(ground > 20, "between the lines of the grid is the canvas' ground");
            assertEquals(theme.colours().background().getRGB(), image.getRGB(1355, 835));
        }
        runOnEdt(Theme.LIGHT::install);
    }

    private void build(Theme theme) {
        runOnEdt(() -> {
            SwingUtilities.updateComponentTreeUI(mainPanel);
            canvas.setPalette(theme.palette());
        });
    }

    private BufferedImage picture() {
        setSizeAndLayOut(1360, 840);
        BufferedImage image = new BufferedImage(1360, 840, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        IntStream.range(0, MAX_FRAMES).forEach(frame -> mainPanel.paint(graphics));
        graphics.dispose();
        return image;
    }

    private void setSizeAndLayOut(int width, int height) {
        mainPanel.setSize(width, height);
        mainPanel.dividers().setPanelWidth(mainPanel.controlPanel().defaultWidth());
        // The second pass places the dividers, the third lays out scroll panes with their bars.
        ComponentFinder.layOut(mainPanel);
        ComponentFinder.layOut(mainPanel);
        ComponentFinder.layOut(mainPanel);
    }

    private Map<Component, Rectangle> places() {
        Map<Component, Rectangle> places = new HashMap<>();
        ComponentFinder.tree(mainPanel).forEach(part -> places.put(part, part.getBounds()));
        return places;
    }

    private static boolean mustBeWhole(Component part) {
        boolean text = part instanceof JLabel label
                && !label.getText().isBlank()
                && !(label.getParent() instanceof CellRendererPane);
        return (text || part instanceof AbstractButton || part instanceof JSpinner || part instanceof JSlider)
                && isVisibleInTab(part)
                && part.getPreferredSize().width > 0
                && !(part.getParent() instanceof Box.Filler);
    }

    /** Returns whether a component and those around it are visible, in its tab if it is in one. */
    private static boolean isVisibleInTab(Component part) {
        Component parent = part.getParent();
        return parent == null || parent instanceof JTabbedPane || part.isVisible() && isVisibleInTab(parent);
    }

    /**
     * Returns whether a component has its preferred size and lies within its parent; scrolled content may be higher.
     */
    private static boolean fits(Component part) {
        Component parent = part.getParent();
        int wanted = part instanceof JSlider ? MIN_SLIDER_WIDTH : part.getPreferredSize().width;
        boolean roomy = part.getWidth() >= wanted || part instanceof JSpinner || parent instanceof JSpinner;
        boolean inside = parent instanceof JViewport
                || part.getX() >= 0
                        && part.getX() + part.getWidth() <= parent.getWidth()
                        && part.getY() >= 0
                        && part.getY() + part.getHeight() <= parent.getHeight();
        return roomy && inside;
    }

    private static boolean isUsed(Component part) {
        boolean arrow = part.getParent() instanceof JScrollBar || part.getParent() instanceof JComboBox;
        return !arrow
                && (part instanceof AbstractButton
                        || part instanceof JSpinner
                        || part instanceof JSlider
                        || part instanceof JTextField
                        || part instanceof SimulationCanvas
                        || part instanceof JToolBar
                        || part instanceof JTableHeader
                        || part instanceof JComboBox);
    }

    private static void assertDistinct(List<AbstractButton> items) {
        List<Integer> mnemonics =
                items.stream().map(AbstractButton::getMnemonic).toList();
        assertTrue(
                mnemonics.stream().allMatch(mnemonic -> mnemonic > 0),
                () -> items.stream().map(AbstractButton::getText).toList().toString());
        assertEquals(
                mnemonics.stream().distinct().toList(),
                mnemonics,
                () -> items.stream().map(AbstractButton::getText).toList().toString());
    }

    private static String describe(Component part) {
        String text = part instanceof JLabel label
                ? label.getText()
                : part instanceof AbstractButton button ? button.getText() : "";
        return part.getClass().getSimpleName() + " \"" + text + "\" " + ComponentFinder.accessibleName(part) + " "
                + part.getBounds() + " wants " + part.getPreferredSize().width + " in "
                + part.getParent().getClass().getSimpleName();
    }

    /** A listener that ignores all events. */
    private static final class NoOpWorkspaceListener implements WorkspaceListener {
        @Override
        public void sessionStarted() {
            throw new AssertionError();
        }

        @Override
        public void titleChanged() {
            throw new AssertionError();
        }

        @Override
        public void taskFailed(TaskKind what, Path file, Throwable why) {
            throw new AssertionError(why);
        }
    }
}
