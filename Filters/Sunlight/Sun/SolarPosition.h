// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the sun is at a date and time. Plain C++17. Michalsky1988: 0.01 degrees from 1950 to 2050.
#ifndef nephoscope_SolarPosition_h
#define nephoscope_SolarPosition_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace nephoscope
{
struct SubsolarPoint
{
  double Longitude = 0, Latitude = 0; // degrees
};

inline int DaysOfMonth(int year, int month)
{
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  constexpr int days[12] = { 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31 };
  return month == 2 && leap ? 29 : days[month - 1];
}

// Minutes east of UTC of "", "Z", " UTC", "+02:00", "-0500" or "+02"; false if it is none.
inline bool OffsetOf(const std::string& text, int& minutes)
{
  minutes = 0;
  const std::string zone = text.substr(std::min(text.find_first_not_of(' '), text.size()));
  if (zone.empty() || zone == "Z" || zone == "z" || zone == "UTC" || zone == "GMT")
  {
    return true;
  }
  char sign = 0;
  int hours = 0, rest = 0, end = 0;
  const bool withColon = std::sscanf(zone.c_str(), "%c%2d:%2d%n", &sign, &hours, &rest, &end) == 3;
  const bool valid =
    withColon || std::sscanf(zone.c_str(), "%c%2d%n%2d%n", &sign, &hours, &end, &rest, &end) >= 2;
  minutes = (sign == '-' ? -1 : 1) * (60 * hours + rest);
  return valid && (sign == '+' || sign == '-') && end == int(zone.size()) && hours >= 0 &&
    hours < 24 && rest >= 0 && rest < 60;
}

// Days since 2000-01-01 12:00 UTC of "2011-10-11 18:30", "2011-10-11T18:30:00Z", "2011-10-11
// 20:30+02:00" or "2011-10-11"; false if it is none.
inline bool DaysOf(const std::string& text, double& days)
{
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, east = 0, end = 0;
  double second = 0;
  char separator = ' ';
  const int found = std::sscanf(text.c_str(), "%d-%d-%d%n%c%d:%d%n:%lf%n", &year, &month, &day,
    &end, &separator, &hour, &minute, &end, &second, &end);
  const bool hasTime = found >= 6 && (separator == ' ' || separator == 'T');
  const bool valid = (found == 3 || hasTime) && month >= 1 && month <= 12 && day >= 1 &&
    day <= DaysOfMonth(year, month) && hour >= 0 && hour < 25 && minute >= 0 && minute < 60 &&
    second >= 0 && second < 61 && OffsetOf(text.substr(end), east);
  if (!valid)
  {
    return false;
  }
  const int a = (14 - month) / 12, y = year + 4800 - a, m = month + 12 * a - 3;
  const int julian = day + (153 * m + 2) / 5 + 365 * y + y / 4 - y / 100 + y / 400 - 32045;
  days = julian - 2451545.0 + (hour - 12) / 24.0 + (minute - east) / 1440.0 + second / 86400.0;
  return true;
}

inline SubsolarPoint FindSubsolarPoint(double days)
{
  const double degree = 3.14159265358979323846 / 180;
  const double meanLongitude = 280.460 + 0.9856474 * days;
  const double anomaly = (357.528 + 0.9856003 * days) * degree;
  const double longitude =
    (meanLongitude + 1.915 * std::sin(anomaly) + 0.020 * std::sin(2 * anomaly)) * degree;
  const double obliquity = (23.439 - 4e-7 * days) * degree;
  const double ascension =
    std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)) / degree;
  const double declination = std::asin(std::sin(obliquity) * std::sin(longitude)) / degree;
  const double greenwich = 15 * (18.697374558 + 24.06570982441908 * days);
  return { std::remainder(ascension - greenwich, 360.0), declination };
}

// Towards the sun, in the frame of a globe: x to longitude 0 on the equator, z to the north pole.
inline std::array<double, 3> TowardsSunOnGlobe(const SubsolarPoint& sun)
{
  const double degree = 3.14159265358979323846 / 180;
  const double lon = sun.Longitude * degree, lat = sun.Latitude * degree;
  return { { std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat) } };
}

// Direction towards the sun at a position: east, north and up components.
inline std::array<double, 3> TowardsSunAt(
  const SubsolarPoint& sun, double longitude, double latitude)
{
  const double degree = 3.14159265358979323846 / 180;
  const auto s = TowardsSunOnGlobe(sun);
  const double lon = longitude * degree, lat = latitude * degree;
  const double east = -std::sin(lon) * s[0] + std::cos(lon) * s[1];
  const double out = std::cos(lon) * s[0] + std::sin(lon) * s[1];
  return { { east, std::cos(lat) * s[2] - std::sin(lat) * out,
    std::cos(lat) * out + std::sin(lat) * s[2] } };
}
}

#endif
