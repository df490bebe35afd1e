package faultline.studies;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.GuiRobot;
import faultline.gui.panel.ControlPanel;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.surface.SvgTheme;
import faultline.studies.figure.FigureFolder;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ControlPanelFigureTest {

    @Test
    void theThemeBeforeTheFigureIsInstalledAfterIt(@TempDir Path folder) throws IOException {
        GuiRobot.runOnEdt(Theme.DARK::install);
        try (FigureFolder figures = FigureFolder.create(folder, SvgTheme.LIGHT)) {
            new ControlPanelFigure().write(figures);
            assertEquals(Theme.DARK, GuiRobot.callOnEdt(Theme::current));
        } finally {
            GuiRobot.runOnEdt(Theme.LIGHT::install);
        }
    }

    /** In a scaled picture letters are wider than in the layout, which cut the ends of labels off. */
    @Test
    void thePictureIsPaintedAtTheScaleOfItsLayout(@TempDir Path folder) throws IOException {
        try (FigureFolder figures = FigureFolder.create(folder, SvgTheme.LIGHT)) {
            new ControlPanelFigure().write(figures);
            figures.commit();
        }
        int width = ImageIO.read(folder.resolve("fig1-panel.png").toFile()).getWidth();
        assertEquals(TextSize.NORMAL, GuiRobot.callOnEdt(TextSize::current));
        GuiRobot.runOnEdt(TextSize.LARGEST::install);
        try {
            assertEquals(TextSize.scaled(ControlPanel.WIDTH), width);
        } finally {
            GuiRobot.runOnEdt(TextSize.NORMAL::install);
        }
    }
}
