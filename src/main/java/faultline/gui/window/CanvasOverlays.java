package faultline.gui.window;

import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.form.StatelessLayout;
import faultline.paint.scene.CornerChoice;
import faultline.paint.scene.CornerChoice.Corner;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;

/**
 * Places the components on top of the canvas where they do not hide the robot, and leaves the view as it is. The banner
 * is along the upper edge, or along the lower one if the robot is at the upper one. The card of the tour is in a
 * corner, which it leaves only when the robot comes near.
 */
final class CanvasOverlays extends StatelessLayout {

    private final SimulationCanvas canvas;
    private final JComponent banner;
    private final CornerChoice bannerEdge = new CornerChoice(Corner.UPPER_LEFT, Corner.LOWER_LEFT);
    private final CornerChoice cardCorner =
            new CornerChoice(Corner.LOWER_RIGHT, Corner.UPPER_RIGHT, Corner.LOWER_LEFT, Corner.UPPER_LEFT);
    /** Null before there is one. */
    private TourCard card;

    /** Lays out the banner on a canvas. */
    CanvasOverlays(SimulationCanvas canvas, JComponent banner) {
        this.canvas = canvas;
        this.banner = banner;
        canvas.setLayout(this);
        canvas.add(banner);
    }

    void addCard(TourCard newCard) {
        card = newCard;
        canvas.add(card);
    }

    /** Moves the components so that they do not cover the robot in the frame that the canvas shows. */
    void update() {
        if (banner.isVisible() || card != null && card.isVisible()) {
            layoutContainer(canvas);
        }
    }

    @Override
    public void layoutContainer(Container parent) {
        List<Rectangle2D> avoided = new ArrayList<>(canvas.robotArea().stream().toList());
        if (banner.isVisible()) {
            Dimension size = new Dimension(parent.getWidth(), banner.getPreferredSize().height);
            move(banner, size, bannerEdge, avoided);
            avoided.add(banner.getBounds());
        }
        if (card != null && card.isVisible()) {
            // A card under the mouse is being used: it stays in its corner.
            boolean used = card.isShowing() && card.getMousePosition(true) != null;
            move(card, card.sizeWithin(parent.getSize()), cardCorner, used ? List.of() : avoided);
        }
    }

    private void move(Component part, Dimension size, CornerChoice choice, List<Rectangle2D> avoided) {
        Rectangle2D box = new Rectangle(size);
        Rectangle bounds =
                choice.place(new Rectangle(canvas.getSize()), box, avoided).getBounds();
        if (!bounds.equals(part.getBounds())) {
            part.setBounds(bounds);
            part.validate();
        }
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        return new Dimension();
    }
}
