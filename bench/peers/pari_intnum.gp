\\ SPDX-License-Identifier: BSD-3-Clause
\\ PARI's intnum and intnumgauss. Reads lines of id family digits u m t K (a = 1; decimals) from
\\ descriptor 3 and writes id, value, evaluations and processor seconds per value (the mean of as many
\\ repeats as its clock of milliseconds needs). The environment variable PEER_RULE is intnum,
\\ intnum-exponent (the integrand in s, with the exponent -1/2 given at s = x) or intnumgauss;
\\ PEER_SECONDS is the time for which a point is repeated. s^2 = x^2 + w^2, or s = t/cos(phi), as in
\\ the other programs.
rule = getenv("PEER_RULE");
enough = 1000*eval(getenv("PEER_SECONDS"));
evaluations = 0;
below(t, x, w) = { evaluations++; my(c = cos(w)); w*sin(w)/(c^2*sqrt(t^2 - x^2*c^2)) };
flat(t, x, w) = { evaluations++; acos(t/sqrt(x^2 + w^2)) };
power(m, x, w) = { evaluations++; (x^2 + w^2)^((m - 1)/2) };
in_s(family, m, t, x, v) =
{
  evaluations++;
  my(s = x + v);
  if(family == "flat", s*acos(t/s), s^m)/sqrt(v*(2*x + v));
};
integral(f, end, table) =
{
  if(rule == "intnumgauss", intnumgauss(w = 0, end, f(w), table), intnum(w = 0, end, f(w), table));
};
pressure(family, u, m, t, K, table) =
{
  my(x = 1 - u, end = sqrt(u*(2 - u)));
  if(family == "flat" && x < t,
    K*t^2/Pi*integral(w -> below(t, x, w), acos(t), table),
    if(rule == "intnum-exponent",
      K/Pi*intnum(v = [0, -1/2], u, in_s(family, m, t, x, v)),
      if(family == "flat",
        K/Pi*integral(w -> flat(t, x, w), end, table),
        K/Pi*integral(w -> power(m, x, w), end, table))));
};
text(format, x) = strjoin(strsplit(strprintf(format, x), " "));
tables = Map();
table_of(digits) =
{
  if(!mapisdefined(tables, digits),
    mapput(tables, digits, if(rule == "intnumgauss", intnumgaussinit(), intnuminit(0, 1))));
  mapget(tables, digits);
};
answer(line) =
{
  my(w = strsplit(line, " "), d = eval(w[3]), n, p, table, begun, spent = 0, repeats = 0, batch = 1);
  default(realprecision, d + 3);
  n = vector(4, k, 1.*eval(w[k + 3]));
  table = if(rule == "intnum-exponent", 0, table_of(d));
  evaluations = 0;
  p = pressure(w[2], n[1], n[2], n[3], n[4], table);
  my(count = evaluations);
  while(spent < enough,
    begun = getabstime();
    for(k = 1, batch, pressure(w[2], n[1], n[2], n[3], n[4], table));
    spent += getabstime() - begun;
    repeats += batch;
    batch *= 2);
  if(imag(p) == 0,
    print(w[1], " ", text(concat(["%.", d + 3, "g"]), p), " ", count, " ",
      text("%.6g", spent/1000./repeats)));
};
lines = readstr("/dev/fd/3");
for(i = 1, #lines, iferr(answer(lines[i]), e, print(strsplit(lines[i], " ")[1], " none ", e)));
