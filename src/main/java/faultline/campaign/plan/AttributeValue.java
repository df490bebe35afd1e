package faultline.campaign.plan;

import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The text of an attribute in a run: fixed, or drawn for each block of runs. */
sealed interface AttributeValue {

    /** An empty text, as in the columns of a fault in a run without a fault. */
    AttributeValue NONE = new FixedValue("");

    /** Returns the text for a block of runs, counted from 0, with the draws of the plan. */
    String text(UniformSource numbers, long block);

    /** Returns the ranges from which it is drawn; none if it is the same in every run. */
    List<DrawRange> ranges();

    /** A text that is the same in every run. */
    record FixedValue(String text) implements AttributeValue {
        @Override
        public String text(UniformSource numbers, long block) {
            return text;
        }

        @Override
        public List<DrawRange> ranges() {
            return List.of();
        }
    }

    /** A text that is drawn from a range. Draws of the same stream are equal in all runs of a block. */
    record DrawnValue(String stream, DrawRange range) implements AttributeValue {
        @Override
        public String text(UniformSource numbers, long block) {
            return range.at(numbers.uniform(stream, block));
        }

        @Override
        public List<DrawRange> ranges() {
            return List.of(range);
        }
    }

    /** The exact sum of two numbers; the first text if either is not a number. */
    record Sum(AttributeValue first, AttributeValue second) implements AttributeValue {
        @Override
        public String text(UniformSource numbers, long block) {
            String text = first.text(numbers, block);
            Optional<BigDecimal> a = DecimalText.parse(text);
            Optional<BigDecimal> b = DecimalText.parse(second.text(numbers, block));
            return a.isEmpty() || b.isEmpty()
                    ? text
                    : a.get().add(b.get()).stripTrailingZeros().toPlainString();
        }

        @Override
        public List<DrawRange> ranges() {
            return Stream.concat(first.ranges().stream(), second.ranges().stream())
                    .toList();
        }
    }

    /** The source of the random numbers of draws. */
    interface UniformSource {

        /** Returns the number of a stream for a block, in [0, 1). */
        double uniform(String stream, long block);
    }
}
