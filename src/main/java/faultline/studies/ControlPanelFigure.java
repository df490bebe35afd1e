package faultline.studies;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.gui.action.UiAction;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.panel.ControlPanel;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.surface.SvgTheme;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import faultline.world.Snapshot;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.util.Optional;

/**
 * Fig. 1: the control panel during a run, painted without a display. It uses a large font instead of scaling the
 * picture, because letters are wider in a scaled picture than in the layout.
 */
final class ControlPanelFigure implements Figure {

    private static final String SCENARIO = "every-fault.xml";
    private static final double SECONDS = 46;

    @Override
    public void write(FigureFolder folder) throws IOException {
        folder.writePng(
                "fig1-panel",
                renderOnEdt(runScenario(), folder.appearance() == SvgTheme.DARK ? Theme.DARK : Theme.LIGHT));
    }

    private static Snapshot runScenario() {
        try (Simulation simulation =
                new Simulation(StudyScenarios.load(SCENARIO).setup(), ControllerMode.DIRECT)) {
            while (simulation.time() < SECONDS) {
                simulation.tick();
            }
            return simulation.snapshot();
        }
    }

    private static BufferedImage renderOnEdt(Snapshot world, Theme theme) throws IOException {
        BufferedImage[] painted = new BufferedImage[1];
        try {
            EventQueue.invokeAndWait(() -> painted[0] = renderLarge(world, theme));
            return painted[0];
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("the control panel was not painted", e);
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(e.getCause());
        }
    }

    private static BufferedImage renderLarge(Snapshot world, Theme theme) {
        TextSize sizeBefore = TextSize.current();
        Theme themeBefore = Theme.current();
        TextSize.LARGEST.install();
        try {
            theme.install();
            return render(world);
        } finally {
            sizeBefore.install();
            themeBefore.install();
        }
    }

    private static BufferedImage render(Snapshot world) {
        CommandSender sender = new CommandSender((commands, results) -> {});
        ControlPanel panel = new ControlPanel(
                sender,
                new ScenarioEditor(new RunController(new Workspace()), new UndoController(sender, () -> {})),
                new ControlPanel.SensorEdits(() -> {}, id -> {}, (id, newId) -> Optional.empty()),
                new ControlPanel.PanelActions(
                        UiAction.toggle("path", true, on -> {}),
                        UiAction.of("chooseController", () -> {}),
                        UiAction.of("scenarioController", () -> {})));
        panel.setSnapshot(world);
        panel.addNotify();
        Dimension size = panel.getPreferredSize();
        panel.setSize(size);
        panel.validate();
        BufferedImage image = new BufferedImage(size.width, size.height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        panel.printAll(graphics);
        graphics.dispose();
        panel.removeNotify();
        return image;
    }
}
