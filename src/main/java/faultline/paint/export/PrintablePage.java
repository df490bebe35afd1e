package faultline.paint.export;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.print.PageFormat;
import java.awt.print.Printable;

/** A picture on one page of paper, centred and as large as possible. */
public record PrintablePage(RenderRequest request) implements Printable {

    @Override
    public int print(Graphics graphics, PageFormat format, int page) {
        if (page > 0) {
            return NO_SUCH_PAGE;
        }
        Graphics2D own = (Graphics2D) graphics.create();
        try {
            own.transform(pageTransform(format));
            own.clipRect(0, 0, request.camera().width(), request.camera().height());
            request.paint(own);
        } finally {
            own.dispose();
        }
        return PAGE_EXISTS;
    }

    /** Returns a format with its paper turned so that the picture is as large as possible. */
    public PageFormat oriented(PageFormat format) {
        PageFormat oriented = (PageFormat) format.clone();
        boolean wide = request.camera().width() > request.camera().height();
        oriented.setOrientation(wide ? PageFormat.LANDSCAPE : PageFormat.PORTRAIT);
        return oriented;
    }

    private AffineTransform pageTransform(PageFormat format) {
        double width = request.camera().width();
        double height = request.camera().height();
        double scale = Math.min(format.getImageableWidth() / width, format.getImageableHeight() / height);
        AffineTransform placed = AffineTransform.getTranslateInstance(
                format.getImageableX() + (format.getImageableWidth() - width * scale) / 2,
                format.getImageableY() + (format.getImageableHeight() - height * scale) / 2);
        placed.scale(scale, scale);
        return placed;
    }
}
