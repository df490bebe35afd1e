package faultline.gui.window;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.edit.CommandSender;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Camera;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.geom.Rectangle2D;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The places of the banner and the card of the tour on a canvas with a world of 6 m by 4 m. */
class CanvasOverlaysTest {

    private SimulationCanvas canvas;
    private CanvasOverlays overlays;
    private JPanel banner;
    private TourCard card;

    @BeforeEach
    void build() {
        runOnEdt(() -> build(TextSize.NORMAL));
    }

    private void build(TextSize size) {
        size.install();
        Theme.LIGHT.install();
        canvas = new SimulationCanvas(new CommandSender((commands, outcome) -> {}));
        banner = new JPanel();
        banner.setPreferredSize(new Dimension(0, 60));
        banner.setVisible(false);
        overlays = new CanvasOverlays(canvas, banner);
        card = new TourCard(List.of(new TourCard.TourStep("break", new JPanel())), target -> {});
        overlays.addCard(card);
        canvas.setSize(845, 373);
    }

    @AfterEach
    void restore() {
        runOnEdt(() -> {
            Messages.setLanguage(Language.ENGLISH);
            TextSize.NORMAL.install();
        });
    }

    private void drive(double x, double y) {
        canvas.setFrame(SampleFrames.frameOf(new Pose(x, y, 0)));
        overlays.update();
    }

    @ParameterizedTest
    @EnumSource(TextSize.class)
    void theCardMovesOutOfTheRobotsWayAndStaysThere(TextSize size) {
        for (Language language : Language.values()) {
            runOnEdt(() -> {
                Messages.setLanguage(language);
                build(size);
                card.start();
                int moves = 0;
                Rectangle before = card.getBounds();
                for (double angle = 0; angle < 4 * Math.PI; angle += 0.05) {
                    drive(3 + 2.5 * Math.cos(angle), 2 + 1.5 * Math.sin(angle));
                    Rectangle now = card.getBounds();
                    assertFalse(now.intersects(kept(size)), now + " at " + angle);
                    assertTrue(canvas.getBounds().contains(now), "cut off: " + now);
                    moves += now.equals(before) ? 0 : 1;
                    before = now;
                }
                assertTrue(moves <= 9, "moves in two laps: " + moves);
            });
        }
    }

    @Test
    void theTextOfACardThatIsHigherThanTheCanvasScrolls() {
        runOnEdt(() -> {
            build(TextSize.LARGEST);
            drive(3, 2);
            card.start();
            JScrollBar bar = ComponentFinder.findAll(card, JScrollPane.class)
                    .findFirst()
                    .orElseThrow()
                    .getVerticalScrollBar();
            overlays.update();
            ComponentFinder.layOut(card);
            assertFalse(bar.isVisible(), "all of the text shows");
            canvas.setSize(448, 140);
            overlays.update();
            ComponentFinder.layOut(card);
            assertEquals(new Rectangle(0, 0, 448, 140), card.getBounds());
            JButton next = ComponentFinder.find(card, JButton.class, "Next");
            assertTrue(new Rectangle(card.getSize())
                    .contains(SwingUtilities.convertRectangle(next.getParent(), next.getBounds(), card)));
            assertTrue(bar.isVisible());
            assertEquals(0, bar.getValue(), "the text begins at its start");
            press("DOWN");
            assertTrue(bar.getValue() > 0);
            press("UP");
            assertEquals(0, bar.getValue());
        });
    }

    @Test
    void theTitleOfACardThatIsNarrowIsWrapped() {
        runOnEdt(() -> {
            build(TextSize.LARGEST);
            drive(3, 2);
            card.start();
            canvas.setSize(200, 373);
            overlays.update();
            ComponentFinder.layOut(card);
            JTextArea title = ComponentFinder.findAll(card, JTextArea.class)
                    .filter(area -> area.getText().startsWith("1 of 1"))
                    .findFirst()
                    .orElseThrow();
            assertEquals(title.getPreferredSize().height, title.getHeight());
            int line = title.getFontMetrics(title.getFont()).getHeight();
            assertTrue(title.getHeight() >= 2 * line, "one line");
        });
    }

    private void press(String key) {
        card.getActionForKeyStroke(KeyStroke.getKeyStroke(key))
                .actionPerformed(new ActionEvent(card, ActionEvent.ACTION_PERFORMED, key));
    }

    /** Returns what the card must not hide: at the largest text size there is room for the platform only. */
    private Rectangle2D kept(TextSize size) {
        Rectangle2D area = canvas.robotArea().orElseThrow();
        if (size != TextSize.LARGEST) {
            return area;
        }
        Vector2 middle = canvas.camera()
                .toScreen(canvas.frame().orElseThrow().snapshot().pose().position());
        return new Rectangle2D.Double(middle.x() - 14, middle.y() - 14, 28, 28);
    }

    @Test
    void theBannerLeavesTheViewAsItIs() {
        runOnEdt(() -> {
            drive(3, 1);
            Camera before = canvas.camera();
            banner.setVisible(true);
            overlays.update();
            assertEquals(new Rectangle(0, 0, 845, 60), banner.getBounds());
            assertEquals(before, canvas.camera());
        });
    }

    @Test
    void theBannerLeavesTheUpperEdgeForTheRobot() {
        runOnEdt(() -> {
            banner.setVisible(true);
            drive(3, 1);
            assertEquals(new Rectangle(0, 0, 845, 60), banner.getBounds());
            drive(3, 3.7);
            assertEquals(new Rectangle(0, 313, 845, 60), banner.getBounds());
            canvas.zoomIn();
            drive(3, 2.2);
            assertEquals(new Rectangle(0, 313, 845, 60), banner.getBounds(), "both edges are free");
        });
    }
}
