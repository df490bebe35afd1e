package faultline.paint.chart;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;

/** Clips lines at the unit square, in which the data of a chart lie before they are mapped to pixels. */
final class LineClipper {

    private LineClipper() {}

    /** Returns the pieces of a line that lie in the square; a point that is not finite ends a piece. */
    static List<List<Vector2>> clip(List<Vector2> line) {
        List<List<Vector2>> pieces = new ArrayList<>();
        List<Vector2> piece = new ArrayList<>();
        for (int i = 1; i < line.size(); i++) {
            List<Vector2> part = clipSegment(line.get(i - 1), line.get(i));
            if (part.isEmpty()
                    || !piece.isEmpty() && !piece.get(piece.size() - 1).equals(part.get(0))) {
                addPiece(piece, pieces);
                piece = new ArrayList<>();
            }
            if (!part.isEmpty()) {
                piece.addAll(piece.isEmpty() ? part : part.subList(1, 2));
            }
        }
        addPiece(piece, pieces);
        return pieces;
    }

    private static void addPiece(List<Vector2> piece, List<List<Vector2>> pieces) {
        if (piece.size() > 1) {
            pieces.add(piece);
        }
    }

    /** Returns the two ends of the part of a segment that lies in the square, by Liang and Barsky, or an empty list. */
    private static List<Vector2> clipSegment(Vector2 a, Vector2 b) {
        if (!a.isFinite() || !b.isFinite()) {
            return List.of();
        }
        double[] toEdge = {a.x(), 1 - a.x(), a.y(), 1 - a.y()};
        double[] against = {a.x() - b.x(), b.x() - a.x(), a.y() - b.y(), b.y() - a.y()};
        double from = 0;
        double to = 1;
        for (int i = 0; i < 4; i++) {
            double t = toEdge[i] / against[i];
            if (against[i] == 0 && toEdge[i] < 0) {
                return List.of();
            }
            from = against[i] < 0 ? Math.max(from, t) : from;
            to = against[i] > 0 ? Math.min(to, t) : to;
        }
        return from < to ? List.of(interpolate(a, b, from), interpolate(a, b, to)) : List.of();
    }

    private static Vector2 interpolate(Vector2 a, Vector2 b, double share) {
        return share == 0 ? a : share == 1 ? b : a.plus(b.minus(a).times(share));
    }
}
