package faultline.campaign.plan;

import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;

/** The set of values from which a value is drawn. */
sealed interface DrawRange {

    /** Returns the value for a uniform random number in [0, 1); it increases with that number. */
    String at(double uniform);

    /** Uniform between two numbers, rounded to six digits. */
    record Uniform(BigDecimal from, BigDecimal to) implements DrawRange {

        private static final MathContext SIX_DIGITS = new MathContext(6);

        @Override
        public String at(double uniform) {
            BigDecimal exact = from.add(to.subtract(from).multiply(new BigDecimal(uniform)));
            BigDecimal rounded = exact.round(SIX_DIGITS).max(from).min(to);
            return DecimalText.format(rounded.doubleValue());
        }
    }

    /** One of several words, each equally likely. */
    record Words(List<String> words) implements DrawRange {

        public Words {
            words = List.copyOf(words);
        }

        @Override
        public String at(double uniform) {
            return words.get((int) (uniform * words.size()));
        }
    }
}
